use super::*;

#[test]
fn the_free_language_survives_the_round_trip() {
    for text in [
        "",
        "frame-anchor",
        "frame-anchor[1,3],length-offset",
        "length-scale,pulley-radius[8]",
        "compliance,wrench",
        "clock-offset",
        "frame-anchor[2],clock-offset",
        "tracker-frame",
        "frame-anchor,clock-offset,tracker-frame,marker-frame",
        "length-offset@52",
        "length-offset,clock-offset,length-offset[3]@52,length-drift[1,2]",
        "length-drift",
    ] {
        let free: FreeParameters = text.parse().unwrap();
        assert_eq!(free.to_string(), text);
    }
}

#[test]
fn what_is_not_the_language_is_refused() {
    for text in [
        "frame",
        "frame-anchor[",
        "frame-anchor[0]",
        "frame-anchor[a]",
        "frame-anchor]",
        "length-offset,",
        "frame-anchor[1]x",
        "complience",
        ",",
        "length-offset@2",
        "length-offset@",
        "length-offset@x",
        "length-offset[3]@5x",
        "length-scale@52",
        "length-drift@52",
        "clock-offset[1]",
        "marker-frame[1]",
        "tracker",
        "frame-anchor[-1]",
        "frame-anchor[99999999999999999999999]",
    ] {
        assert!(text.parse::<FreeParameters>().is_err(), "{text}");
    }
}
