package nephele.engine.render.pass.cloud;

import nephele.engine.render.frame.Defines;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.frame.FrameUniforms;

/**
 * The uniforms of {@code cloud-pixel.glsl}, which the programs of all techniques have.
 *
 * @param ranges {@code null} unless for {@link CloudPixels#MIXED}
 * @param rays {@code null} unless of a {@link RayGrid}
 * @param flash {@code null} unless for {@link CloudPixels#FLASH}
 * @param boltFromEye {@code null} unless for {@link CloudPixels#BOLT}
 * @param share of the optical depth that is drawn; {@code null} unless in a view
 */
public record PixelUniforms(
        CloudRanges.Places ranges,
        Rays rays,
        FlashUniforms flash,
        Uniforms.Vector3 boltFromEye,
        Uniforms.Scalar share) {
    /**
     * The rays of a grid that are drawn.
     *
     * @param blown how far the wind has carried the cloud since the layer before; {@code null} without one
     * @param plane distance of a captured picture along the view's axis, metres; {@code null} unless of one
     */
    record Rays(Uniforms.Vector2 step, Uniforms.Vector3 square, Uniforms.Vector3 blown, Uniforms.Scalar plane) {
        static Rays of(Uniforms uniforms, CloudPixels pixels) {
            return new Rays(
                    uniforms.vector2("layerStep"),
                    uniforms.vector3("marchedSquare"),
                    pixels == CloudPixels.WHOLE ? uniforms.vector3("blown") : null,
                    pixels == CloudPixels.CAPTURED ? uniforms.scalar("capturedPlane") : null);
        }
    }

    /** Returns the definitions of a program. */
    public static Defines defines(CloudContext context, CloudPixels pixels) {
        return Defines.of(context.load())
                .withIf(pixels.isGrid(), "WHOLE")
                .withIf(pixels == CloudPixels.CAPTURED, "CAPTURED")
                .withIf(pixels == CloudPixels.FLASH, "BY_FLASH")
                .withIf(pixels == CloudPixels.BOLT, "OF_BOLT")
                .with("FLASH_LIGHTS", FlashUniforms.LIGHTS)
                .withIf(pixels == CloudPixels.MIXED, "MIXED")
                .withIf(pixels == CloudPixels.BAKED, "BAKED")
                .withIf(pixels.isShared(), "SHARED")
                .with("CLOUDS", context.ranges());
    }

    /** Finds the uniforms of a program and assigns its samplers. */
    public static PixelUniforms of(Uniforms uniforms, CloudContext context, CloudPixels pixels) {
        if (pixels == CloudPixels.ALL || pixels == CloudPixels.MIXED) {
            uniforms.sampler("viewDepth", TextureUnit.VIEW_DEPTH);
        }
        boolean isBolt = pixels == CloudPixels.BOLT;
        if (isBolt) {
            uniforms.sampler("boltPoints", TextureUnit.BOLT_POINTS);
        }
        return new PixelUniforms(
                pixels == CloudPixels.MIXED ? uniforms.record(CloudRanges.Places.class) : null,
                pixels.isGrid() ? Rays.of(uniforms, pixels) : null,
                pixels == CloudPixels.FLASH ? FlashUniforms.of(uniforms) : null,
                isBolt ? uniforms.vector3("boltFromEye") : null,
                pixels.isShared() ? uniforms.scalar("cloudShare") : null);
    }
}
