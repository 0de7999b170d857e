package nephele.engine.render.frame;

import nephele.engine.render.gl.shader.TextureUnit;

/** The targets by which passes depend on each other. */
public enum Target {
    /** The target of surfaces: linear for output HDR, else display-referred; afterwards what the passes make of it. */
    SURFACE(null),
    /** The exposure of this picture, metered from it. */
    EXPOSURE(TextureUnit.EXPOSURE),
    /** The final 8-bit picture, display-referred. */
    PICTURE(null),
    SUN_SHADOW(TextureUnit.SUN_SHADOW),
    LIGHT_SHADOW(TextureUnit.LIGHT_SHADOW),
    /** The sun's depth map of dynamic objects. */
    DYNAMIC_SUN_SHADOW(TextureUnit.DYNAMIC_SUN_SHADOW),
    DYNAMIC_LIGHT_SHADOW(TextureUnit.DYNAMIC_LIGHT_SHADOW),
    /** The fraction of the sky that the static faces see. */
    SKY_VISIBILITY(TextureUnit.SKY_VISIBILITY),
    /** Light on the static faces that was baked; its second layer, if there is one, has directions. */
    BAKED_LIGHT(TextureUnit.BAKED_LIGHT),
    /** The share of the sun's light that clouds leave, in a region around the level. */
    CLOUD_SHADE(TextureUnit.CLOUD_SHADE),
    /** The share of the light of each point of a bolt of lightning that clouds let through to the eye of the current view. */
    BOLT_TRANSMITTANCE(TextureUnit.BOLT_TRANSMITTANCE),
    /**
     * Window depth 0–1 of the current view after its opaque surfaces, at the same pixels; only for passes of {@link
     * Stage#IN_VIEWS_AFTER_OPAQUE}.
     */
    VIEW_DEPTH(TextureUnit.VIEW_DEPTH),
    /** The colours at those pixels, in the form that surfaces store. */
    VIEW_COLOUR(TextureUnit.VIEW_COLOUR);

    private final TextureUnit unit;

    Target(TextureUnit unit) {
        this.unit = unit;
    }

    /** Returns the texture unit for reads; {@code null} for targets that are only drawn into. */
    public TextureUnit unit() {
        return unit;
    }
}
