//! Fewer points for the same picture.

/// A place on the paper, px.
pub type PaperPoint = (f64, f64);

/// Longest stretch simplified at once; bounds the time that a line of a million points can take.
const STRETCH: usize = 2048;

/// A line that is nowhere further than about `tolerance` px from the one through `places`.
pub fn line(places: &[PaperPoint], tolerance: f64) -> Vec<PaperPoint> {
    let places = columns(places, tolerance);
    let mut kept = Vec::new();
    let mut start = 0;
    while start + 1 < places.len() {
        let end = (start + STRETCH).min(places.len() - 1);
        stretch(&places[start..=end], tolerance, &mut kept);
        start = end;
    }
    kept.extend(places.last());
    kept
}

/// Of consecutive places within one column of paper, the first, the highest, the lowest and the last, in order.
fn columns(places: &[PaperPoint], width: f64) -> Vec<PaperPoint> {
    let mut kept = Vec::new();
    let mut start = 0;
    while start < places.len() {
        let left = places[start].0;
        let run = places[start..]
            .iter()
            .take_while(|place| (place.0 - left).abs() < width)
            .count()
            .max(1);
        let column = &places[start..start + run];
        if run <= 4 {
            kept.extend(column);
        } else {
            let (mut high, mut low) = (0, 0);
            for (i, place) in column.iter().enumerate() {
                if place.1 > column[high].1 {
                    high = i;
                }
                if place.1 < column[low].1 {
                    low = i;
                }
            }
            let mut chosen = [0, high.min(low), high.max(low), run - 1].to_vec();
            chosen.dedup();
            kept.extend(chosen.into_iter().map(|i| column[i]));
        }
        start += run;
    }
    kept
}

/// Douglas and Peucker 1973, without recursion; adds all but the last place.
fn stretch(places: &[PaperPoint], tolerance: f64, kept: &mut Vec<PaperPoint>) {
    let mut keep = vec![false; places.len()];
    keep[0] = true;
    let mut open = vec![(0, places.len() - 1)];
    while let Some((first, last)) = open.pop() {
        let mut farthest = (first, tolerance);
        for i in first + 1..last {
            let distance = distance(places[i], places[first], places[last]);
            if distance > farthest.1 {
                farthest = (i, distance);
            }
        }
        if farthest.0 > first {
            keep[farthest.0] = true;
            open.push((first, farthest.0));
            open.push((farthest.0, last));
        }
    }
    let last = places.len() - 1;
    kept.extend((0..last).filter(|&i| keep[i]).map(|i| places[i]));
}

/// Distance of `p` from the piece of line between `a` and `b`.
fn distance(p: PaperPoint, a: PaperPoint, b: PaperPoint) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let length = dx * dx + dy * dy;
    let along = if length > 0.0 {
        (((p.0 - a.0) * dx + (p.1 - a.1) * dy) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (p.0 - a.0 - along * dx).hypot(p.1 - a.1 - along * dy)
}

#[cfg(test)]
mod tests {
    use super::{distance, line};

    #[test]
    fn every_left_out_place_is_within_the_tolerance_of_the_line() {
        // a parabola with a step in it, as a ball's path on a coarse screen
        let places: Vec<_> = (0..5000)
            .map(|i| {
                let x = f64::from(i) * 0.16;
                (x, 0.001 * x * x + if i < 2500 { 0.0 } else { 50.0 })
            })
            .collect();
        let kept = line(&places, 0.25);
        assert!(kept.len() < 60, "{} points are left", kept.len());
        assert_eq!((kept.first(), kept.last()), (places.first(), places.last()));
        for place in places {
            let nearest = kept
                .windows(2)
                .map(|pair| distance(place, pair[0], pair[1]))
                .fold(f64::INFINITY, f64::min);
            // the column rule and the line rule each may move it by the tolerance
            assert!(nearest <= 0.5, "{place:?} is {nearest} px off");
        }
    }

    #[test]
    fn short_lines_stay_as_they_are() {
        for n in 0..3 {
            let places: Vec<_> = (0..n).map(|i| (f64::from(i), 0.0)).collect();
            assert_eq!(line(&places, 0.25), places);
        }
    }
}
