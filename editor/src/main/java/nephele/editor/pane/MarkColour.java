package nephele.editor.pane;

/** The meaning of a mark's colour; drawing decides the shades, which differ in brightness, too, not in hue alone. */
public enum MarkColour {
    GRID,
    GRID_MAJOR,
    /** Contour lines and outlines of terrains in plans. */
    GROUND,
    /** Every fifth contour line, borders and skylines of terrains. */
    GROUND_MAJOR,
    AXIS_X,
    AXIS_Y,
    AXIS_Z,
    /** Edges of brushes that are not selected. */
    EDGE,
    SELECTED,
    HOVERED,
    /** The result of the drag in progress. */
    PREVIEW,
    /** Guides, measures and links between entities. */
    GUIDE,
    /** Symbols of entities that have no surface: lamps, starts, exits, cameras, clouds. */
    ENTITY,
    /** A portal fits here, or an action is permitted. */
    ALLOWED,
    /** A portal slides to another place. */
    SLIDES,
    /** A portal or an action is refused here. */
    REFUSED,
    PROBLEM
}
