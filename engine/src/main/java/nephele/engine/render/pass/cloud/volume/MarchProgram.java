package nephele.engine.render.pass.cloud.volume;

import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudPixels;
import nephele.engine.render.pass.cloud.PixelUniforms;

/** {@code volume.frag} with the places of its numbers. */
final class MarchProgram {
    /** Boxes that a cloud has at most. */
    private static final int MOST_BOXES = 6;

    private static final String SHARED = "/nephele/engine/render/pass/cloud/";
    private static final String FOLDER = SHARED + "volume/";

    private final GlProgram<Places> program;

    /** The numbers of a cloud and of the light around it. */
    record Places(
            List<Uniforms.Vector4> boxes,
            Uniforms.Vector4 cells,
            Uniforms.Vector4 cellEdges,
            Uniforms.Vector3 cloudBase,
            Uniforms.Vector3 cloudHalf,
            Uniforms.Vector4 medium,
            Uniforms.Vector4 phase,
            Uniforms.Vector3 cloudSun,
            Uniforms.Vector4 diffuseAxis,
            Uniforms.Vector4 stepping,
            Uniforms.Vector3 irradiance,
            Uniforms.Vector3 skyAbove,
            Uniforms.Vector3 skyBelow) {
        /** @param scattering octaves have no {@code diffuseAxis}, which is then {@code null} */
        static Places of(Uniforms uniforms, CloudScattering scattering) {
            return new Places(
                    IntStream.range(0, MOST_BOXES)
                            .mapToObj(i -> uniforms.vector4("boxes[" + i + "]"))
                            .toList(),
                    uniforms.vector4("cells"),
                    uniforms.vector4("cellEdges"),
                    uniforms.vector3("cloudBase"),
                    uniforms.vector3("cloudHalf"),
                    uniforms.vector4("medium"),
                    uniforms.vector4("phase"),
                    uniforms.vector3("cloudSun"),
                    scattering == CloudScattering.TWO_STREAM ? uniforms.vector4("diffuseAxis") : null,
                    uniforms.vector4("stepping"),
                    uniforms.vector3("irradiance"),
                    uniforms.vector3("skyAbove"),
                    uniforms.vector3("skyBelow"));
        }
    }

    /** Where the density comes from. */
    enum Noise {
        /** From cells. */
        NONE,
        STILL,
        EVOLVING
    }

    private final PixelUniforms pixelUniforms;
    private final NoiseTextures.Places noisePlaces;

    MarchProgram(CloudContext context, CloudPixels pixels, Noise noise) {
        CloudScattering scattering = context.load().quality().cloudScattering();
        var defines = PixelUniforms.defines(context, pixels)
                .withIf(noise != Noise.NONE, "NOISE")
                .withIf(noise == Noise.EVOLVING, "EVOLVING")
                .withIf(scattering == CloudScattering.OCTAVES, "OCTAVES")
                .with("MOST_BOXES", MOST_BOXES)
                .values();
        var found = new PixelUniforms[1];
        var tables = new NoiseTextures.Places[1];
        program = new GlProgram<>(
                context.load().gl(),
                ShaderSource.load(SHARED + "cloud.vert", defines),
                ShaderSource.load(FOLDER + "volume.frag", defines),
                uniforms -> {
                    found[0] = PixelUniforms.of(uniforms, context, pixels);
                    uniforms.sampler("cloudDensity", TextureUnit.CLOUD_DENSITY);
                    uniforms.sampler("cloudLight", TextureUnit.CLOUD_LIGHT);
                    uniforms.sampler("cloudLightToCome", TextureUnit.CLOUD_LIGHT_TO_COME);
                    if (scattering == CloudScattering.TWO_STREAM) {
                        uniforms.sampler("smallAngles", TextureUnit.SMALL_ANGLES);
                    }
                    tables[0] = noise == Noise.NONE ? null : NoiseTextures.Places.of(uniforms, noise == Noise.EVOLVING);
                    return Places.of(uniforms, scattering);
                });
        noisePlaces = tables[0];
        pixelUniforms = found[0];
    }

    PixelUniforms pixels() {
        return pixelUniforms;
    }

    /** Returns {@code null} if the density comes from cells. */
    NoiseTextures.Places noisePlaces() {
        return noisePlaces;
    }

    void use() {
        program.use();
    }

    Places places() {
        return program.uniforms();
    }
}
