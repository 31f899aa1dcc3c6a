//! Arguments in, exit code out.

fn main() -> std::process::ExitCode {
    carom::cli::main()
}
