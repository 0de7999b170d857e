package nephele.engine.render.frame;

/** The technique of drawing a view through an opening. */
public enum PortalTechnique {
    /** Draws directly into the picture; a stencil holds the number of openings through which a pixel is seen. */
    STENCIL,
    /** Draws into a separate picture, which then covers the opening. */
    TEXTURE,
    /** Draws into the picture, copies the whole of it and draws over it, as before framebuffer objects existed. */
    COPY,
    /** Copies only the part that the opening needs, otherwise like COPY. */
    COPY_AREA;

    /** Returns true if the content of an opening is a picture before the opening is drawn. */
    public boolean hasPictures() {
        return this != STENCIL;
    }

    public boolean copies() {
        return this == COPY || this == COPY_AREA;
    }
}
