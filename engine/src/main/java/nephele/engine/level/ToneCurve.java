package nephele.engine.level;

/** How scene radiance becomes display light: clipped, or rolled off in the highlights. */
public enum ToneCurve {
    CLIP,
    FILMIC
}
