package nephele.engine.render.frame;

/** How what is seen through a portal gets into the picture. */
public enum PortalTechnique {
    /** Drawn straight into the picture, where a stencil holds how many openings a pixel is seen through. */
    STENCIL,
    /** Drawn into a picture of its own, which then covers the opening. */
    TEXTURE
}
