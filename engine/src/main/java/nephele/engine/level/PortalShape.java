package nephele.engine.level;

/** The outline of a portal's aperture. */
public enum PortalShape {
    ARCH,
    ELLIPSE,
    RECTANGLE
}
