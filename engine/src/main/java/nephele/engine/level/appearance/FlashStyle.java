package nephele.engine.level.appearance;

/** How flashes of lightning come and go. */
public enum FlashStyle {
    /** As in nature: several strokes, each within milliseconds. */
    NATURAL,
    /** Dimmer, with one slow rise and fall in the place of strokes, for people whom flashes harm. */
    SOFTENED
}
