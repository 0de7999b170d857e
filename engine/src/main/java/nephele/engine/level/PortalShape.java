package nephele.engine.level;

/** Outline of a portal's aperture. */
public enum PortalShape {
    ARCH,
    ELLIPSE,
    RECTANGLE
}
