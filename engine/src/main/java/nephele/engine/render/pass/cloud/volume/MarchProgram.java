package nephele.engine.render.pass.cloud.volume;

import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.FrameUniforms;

/** {@code volume.frag} with the places of its numbers. */
final class MarchProgram {
    /** Boxes that a cloud has at most. */
    private static final int MOST_BOXES = 6;

    private static final String FOLDER = "/nephele/engine/render/pass/cloud/volume/";

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

    /** The rays of a layer that are marched, and how far the wind has carried the cloud since the layer before. */
    record Rays(Uniforms.Vector2 step, Uniforms.Vector3 square, Uniforms.Vector3 blown) {
        static Rays of(Uniforms uniforms) {
            return new Rays(
                    uniforms.vector2("layerStep"), uniforms.vector3("marchedSquare"), uniforms.vector3("blown"));
        }
    }

    /** Which pixels a program draws. */
    enum Pixels {
        /** All, as far as surfaces let them see. */
        ALL,
        /** All of a layer, as if there were no surfaces. */
        WHOLE,
        /** Those whose surface is among the clouds. */
        MIXED
    }

    /** Where the density comes from. */
    enum Noise {
        /** From cells. */
        NONE,
        STILL,
        EVOLVING
    }

    private final CloudRanges.Places ranges;
    private final NoiseTextures.Places noisePlaces;
    private final Rays rays;

    MarchProgram(LoadContext context, Pixels pixels, Noise noise, int clouds) {
        Defines choices = Defines.of(context)
                .withIf(pixels == Pixels.WHOLE, "WHOLE")
                .withIf(pixels == Pixels.MIXED, "MIXED")
                .withIf(noise != Noise.NONE, "NOISE")
                .withIf(noise == Noise.EVOLVING, "EVOLVING")
                .withIf(context.quality().cloudScattering() == CloudScattering.OCTAVES, "OCTAVES")
                .with("MOST_BOXES", MOST_BOXES)
                .with("CLOUDS", clouds);
        var defines = choices.values();
        var found = new CloudRanges.Places[1];
        var rayPlaces = new Rays[1];
        var tables = new NoiseTextures.Places[1];
        program = new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "volume.vert", defines),
                ShaderSource.load(FOLDER + "volume.frag", defines),
                uniforms -> {
                    uniforms.block("Frame", FrameUniforms.BINDING);
                    if (pixels != Pixels.WHOLE) {
                        uniforms.sampler("viewDepth", TextureUnit.VIEW_DEPTH);
                    }
                    uniforms.sampler("cloudDensity", TextureUnit.CLOUD_DENSITY);
                    uniforms.sampler("cloudLight", TextureUnit.CLOUD_LIGHT);
                    uniforms.sampler("cloudLightToCome", TextureUnit.CLOUD_LIGHT_TO_COME);
                    if (context.quality().cloudScattering() == CloudScattering.TWO_STREAM) {
                        uniforms.sampler("smallAngles", TextureUnit.SMALL_ANGLES);
                    }
                    found[0] = pixels == Pixels.MIXED ? CloudRanges.Places.of(uniforms, clouds) : null;
                    rayPlaces[0] = pixels == Pixels.WHOLE ? Rays.of(uniforms) : null;
                    tables[0] = noise == Noise.NONE ? null : NoiseTextures.Places.of(uniforms, noise == Noise.EVOLVING);
                    return Places.of(uniforms, context.quality().cloudScattering());
                });
        noisePlaces = tables[0];
        ranges = found[0];
        rays = rayPlaces[0];
    }

    /** Returns where the ranges of clouds go; {@code null} unless for {@link Pixels#MIXED}. */
    CloudRanges.Places ranges() {
        return ranges;
    }

    /** Returns {@code null} if the density comes from cells. */
    NoiseTextures.Places noisePlaces() {
        return noisePlaces;
    }

    /** Returns where the choice of rays goes; {@code null} unless for {@link Pixels#WHOLE}. */
    Rays rays() {
        return rays;
    }

    void use() {
        program.use();
    }

    Places places() {
        return program.uniforms();
    }
}
