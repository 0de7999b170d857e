package nephele.engine.level;

/** A sky full of clouds that the engine makes, in the words of weather reports: few is an eighth or two of the sky. */
public enum Weather {
    CLEAR,
    FEW,
    SCATTERED,
    BROKEN,
    OVERCAST,
    STORM,
    CIRRUS
}
