package nephele.engine.level;

/** The curve from scene radiance to display light: clipped, or rolled off in the highlights. */
public enum ToneCurve {
    CLIP,
    FILMIC
}
