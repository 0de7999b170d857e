package nephele.engine.render.line;

/** The order of what a canvas holds; within a layer, the later is on top. */
public enum LineLayer {
    /** Hidden by what the picture's depth has in front of it. */
    BEHIND_SURFACES,
    /** Drawn over everything. */
    OVER_ALL
}
