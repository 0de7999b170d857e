package nephele.engine.render.pass.cloud;

import nephele.engine.render.frame.Defines;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.FrameUniforms;

/**
 * The uniforms of {@code cloud-pixel.glsl}, which the programs of all techniques have.
 *
 * @param ranges {@code null} unless for {@link CloudPixels#MIXED}
 * @param rays {@code null} unless for {@link CloudPixels#WHOLE}
 */
public record PixelUniforms(CloudRanges.Places ranges, Rays rays) {
    /** The rays of a layer that are drawn, and how far the wind has carried the cloud since the layer before. */
    record Rays(Uniforms.Vector2 step, Uniforms.Vector3 square, Uniforms.Vector3 blown) {
        static Rays of(Uniforms uniforms) {
            return new Rays(
                    uniforms.vector2("layerStep"), uniforms.vector3("marchedSquare"), uniforms.vector3("blown"));
        }
    }

    /** Returns the definitions of a program. */
    public static Defines defines(CloudContext context, CloudPixels pixels) {
        return Defines.of(context.load())
                .withIf(pixels == CloudPixels.WHOLE, "WHOLE")
                .withIf(pixels == CloudPixels.MIXED, "MIXED")
                .with("CLOUDS", context.ranges());
    }

    /** Finds the uniforms of a program and assigns its samplers. */
    public static PixelUniforms of(Uniforms uniforms, CloudContext context, CloudPixels pixels) {
        uniforms.block("Frame", FrameUniforms.BINDING);
        if (pixels != CloudPixels.WHOLE) {
            uniforms.sampler("viewDepth", TextureUnit.VIEW_DEPTH);
        }
        return new PixelUniforms(
                pixels == CloudPixels.MIXED ? CloudRanges.Places.of(uniforms, context.ranges()) : null,
                pixels == CloudPixels.WHOLE ? Rays.of(uniforms) : null);
    }
}
