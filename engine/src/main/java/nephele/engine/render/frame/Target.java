package nephele.engine.render.frame;

import nephele.engine.render.gl.shader.TextureUnit;

/** What passes hand on to each other. */
public enum Target {
    /** What surfaces draw into: the linear picture for output HDR, else the final one. */
    SURFACE(null),
    /** The final 8-bit picture, display-referred. */
    PICTURE(null),
    SUN_SHADOW(TextureUnit.SUN_SHADOW),
    LIGHT_SHADOW(TextureUnit.LIGHT_SHADOW),
    /** The sun's depth map of what moves. */
    DYNAMIC_SUN_SHADOW(TextureUnit.DYNAMIC_SUN_SHADOW),
    DYNAMIC_LIGHT_SHADOW(TextureUnit.DYNAMIC_LIGHT_SHADOW),
    /** Light map of the static faces. */
    SKY_VISIBILITY(TextureUnit.SKY_VISIBILITY),
    /**
     * Window depth 0–1 of the view that is drawn, as its opaque surfaces left it, at the same pixels; only for passes of
     * {@link Stage#IN_VIEWS_AFTER_OPAQUE}.
     */
    VIEW_DEPTH(TextureUnit.VIEW_DEPTH),
    /** The colours at those pixels, as surfaces store them. */
    VIEW_COLOUR(TextureUnit.VIEW_COLOUR);

    private final TextureUnit unit;

    Target(TextureUnit unit) {
        this.unit = unit;
    }

    /** Where it is bound to be read; {@code null} for what is drawn into. */
    public TextureUnit unit() {
        return unit;
    }
}
