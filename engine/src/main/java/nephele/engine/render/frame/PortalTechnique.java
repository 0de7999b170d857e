package nephele.engine.render.frame;

/** How what is seen through a portal gets into the picture. */
public enum PortalTechnique {
    /** Drawn straight into the picture, where a stencil holds how many openings a pixel is seen through. */
    STENCIL,
    /** Drawn into a picture of its own, which then covers the opening. */
    TEXTURE,
    /** Drawn into the picture, copied out of it whole, and drawn over: what was done before frame buffers could be chosen. */
    COPY,
    /** As COPY, but only the part that the opening needs is copied. */
    COPY_AREA;

    /** Whether what is behind an opening is a picture before it is drawn. */
    public boolean hasPictures() {
        return this != STENCIL;
    }

    public boolean copies() {
        return this == COPY || this == COPY_AREA;
    }
}
