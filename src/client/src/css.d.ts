// Style sheets are imported for the bundle; esbuild writes them beside the script.
declare module "*.css";
