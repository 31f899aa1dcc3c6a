//! Colours of pictures: read from the style sheet, held against the paper, and seen with the eyes of colour-blind people.

use carom::report::svg::STYLE;

/// Red, green and blue light, 0 to 1, linear.
type Light = [f64; 3];

/// What a person without one kind of cones sees, in linear light: G. M. Machado, M. M. Oliveira and L. A. F. Fernandes, A physiologically-based
/// model for simulation of color vision deficiency, IEEE Transactions on Visualization and Computer Graphics 15 (2009) 1291,
/// doi:10.1109/TVCG.2009.113, severity 1.
const EYES: [(&str, [[f64; 3]; 3]); 4] = [
    (
        "all cones",
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    ),
    (
        "no long",
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
    ),
    (
        "no middle",
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ],
    ),
    (
        "no short",
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ],
    ),
];

/// What WCAG 2.2, 1.4.11, asks of a part of a picture that is needed to understand it.
const CONTRAST: f64 = 3.0;

/// Least distance of two colours in CIE 1976 L*a*b*: 2.3 is what is just noticed side by side (M. Mahy, L. Van Eycken and A. Oosterlinck,
/// Color Research and Application 19 (1994) 105), and thin lines need several times that.
const APART: f64 = 15.0;

/// The value of a variable in the style for paper (0) or the dark (1), in linear light.
fn colour(name: &str, theme: usize) -> Light {
    let blocks: Vec<&str> = STYLE.split(".fig{").skip(1).collect();
    let block = blocks[theme].split('}').next().unwrap();
    let key = format!("--{name}:#");
    let value = block
        .split(&key)
        .nth(1)
        .unwrap_or_else(|| panic!("no {name} in theme {theme}"));
    let digits: String = value
        .chars()
        .take_while(char::is_ascii_hexdigit)
        .flat_map(|c| [c, c])
        .collect();
    let digit = |k: usize| match digits.len() {
        // three digits, each for two
        6 => &digits[2 * k..2 * k + 2],
        12 => &digits[4 * k..4 * k + 4],
        n => panic!("{name}: {n} digits"),
    };
    std::array::from_fn(|k| {
        let pair = digit(k);
        let pair = match pair.len() {
            4 => format!("{}{}", &pair[..1], &pair[2..3]),
            _ => pair.to_owned(),
        };
        let x = f64::from(u8::from_str_radix(&pair, 16).unwrap()) / 255.0;
        // IEC 61966-2-1
        if x <= 0.04045 {
            x / 12.92
        } else {
            ((x + 0.055) / 1.055).powf(2.4)
        }
    })
}

fn luminance(light: Light) -> f64 {
    0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2]
}

fn contrast(a: Light, b: Light) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

/// As the light looks to these eyes.
fn seen(eyes: [[f64; 3]; 3], light: Light) -> Light {
    std::array::from_fn(|k| {
        let sum: f64 = (0..3).map(|j| eyes[k][j] * light[j]).sum();
        sum.clamp(0.0, 1.0)
    })
}

/// CIE 1976 L*a*b* under D65.
fn lab(light: Light) -> [f64; 3] {
    let [r, g, b] = light;
    let x = (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505;
    let z = (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.0891;
    let f = |t: f64| {
        if t > 216.0 / 24389.0 {
            t.cbrt()
        } else {
            (24389.0 / 27.0 * t + 16.0) / 116.0
        }
    };
    let (x, y, z) = (f(x), f(luminance(light)), f(z));
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn distance(a: Light, b: Light) -> f64 {
    let (a, b) = (lab(a), lab(b));
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

fn series(theme: usize) -> Vec<Light> {
    (0..7).map(|k| colour(&format!("k{k}"), theme)).collect()
}

#[test]
fn the_measures_know_black_white_and_red() {
    let (black, white, red) = ([0.0; 3], [1.0; 3], [1.0, 0.0, 0.0]);
    assert!((contrast(black, white) - 21.0).abs() < 1e-9);
    assert!((distance(black, white) - 100.0).abs() < 0.01);
    // L*a*b* of the red of sRGB as published, to the digits that are: 53.24 80.09 67.20
    for (ours, published) in lab(red).into_iter().zip([53.24, 80.09, 67.20]) {
        assert!((ours - published).abs() < 0.05, "{ours} {published}");
    }
    // a grey stays the grey that it is for all eyes: the rows of each matrix sum to 1
    for (who, eyes) in EYES {
        let grey = seen(eyes, [0.5; 3]);
        assert!(distance(grey, [0.5; 3]) < 0.01, "{who}: {grey:?}");
    }
}

#[test]
fn every_colour_stands_out_from_paper_and_cloth() {
    for theme in 0..2 {
        for ground in ["paper", "cloth"] {
            let behind = colour(ground, theme);
            for (k, light) in series(theme).into_iter().enumerate() {
                let contrast = contrast(light, behind);
                assert!(
                    contrast >= CONTRAST,
                    "theme {theme}: colour {k} on {ground}: {contrast:.2}"
                );
            }
            // words are small: 4.5
            for words in ["ink", "soft"] {
                let contrast = contrast(colour(words, theme), behind);
                assert!(
                    contrast >= 4.5,
                    "theme {theme}: {words} on {ground}: {contrast:.2}"
                );
            }
        }
    }
}

#[test]
fn colour_blind_people_can_tell_all_colours_apart() {
    for theme in 0..2 {
        let lights = series(theme);
        for (who, eyes) in EYES {
            for (i, &a) in lights.iter().enumerate() {
                for (j, &b) in lights.iter().enumerate().skip(i + 1) {
                    let distance = distance(seen(eyes, a), seen(eyes, b));
                    assert!(
                        distance >= APART,
                        "theme {theme}, {who}: colours {i} and {j} are {distance:.1} apart"
                    );
                }
            }
        }
    }
}

#[test]
fn shades_of_fields_grow_darker_with_what_they_ask_for() {
    for theme in 0..2 {
        let shades = ["paper", "u0", "u1", "u2"].map(|name| colour(name, theme));
        let contrasts: Vec<f64> = shades[1..]
            .iter()
            .map(|s| contrast(shades[0], *s))
            .collect();
        assert!(
            contrasts.windows(2).all(|pair| pair[1] >= 1.3 * pair[0]),
            "theme {theme}: {contrasts:.2?}"
        );
        // the cross on the darkest is drawn in the colour of the paper
        assert!(contrasts[2] >= 4.5, "theme {theme}: {contrasts:.2?}");
    }
}
