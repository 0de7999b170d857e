package nephele.engine.render.pass.cloud.volume;

import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.pass.cloud.CellUniforms;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudPixels;
import nephele.engine.render.pass.cloud.DensityUniforms;
import nephele.engine.render.pass.cloud.PixelUniforms;

/** {@code volume.frag} with the places of its numbers. */
final class MarchProgram {
    private static final String SHARED = "/nephele/engine/render/pass/cloud/";
    private static final String FOLDER = SHARED + "volume/";

    private final GlProgram<Places> program;

    /** The numbers of steps. */
    record Places(Uniforms.Vector4 cellEdges, Uniforms.Vector4 stepping) {}

    /** Where the density comes from. */
    enum Noise {
        /** From cells. */
        NONE,
        STILL,
        EVOLVING
    }

    private final PixelUniforms pixelUniforms;
    private final CellUniforms cellUniforms;
    private final DensityUniforms densityUniforms;
    private final NoiseTextures.Places noisePlaces;

    MarchProgram(CloudContext context, CloudPixels pixels, Noise noise) {
        CloudScattering scattering = context.load().quality().cloudScattering();
        var defines = PixelUniforms.defines(context, pixels)
                .withIf(noise != Noise.NONE, "NOISE")
                .withIf(noise == Noise.EVOLVING, "EVOLVING")
                .withIf(scattering == CloudScattering.OCTAVES, "OCTAVES")
                .with("MOST_BOXES", DensityUniforms.MOST_BOXES)
                .values();
        var found = new PixelUniforms[1];
        var cells = new CellUniforms[1];
        var density = new DensityUniforms[1];
        var tables = new NoiseTextures.Places[1];
        program = new GlProgram<>(
                context.load().gl(),
                ShaderSource.load(SHARED + "cloud.vert", defines),
                ShaderSource.load(FOLDER + "volume.frag", defines),
                uniforms -> {
                    found[0] = PixelUniforms.of(uniforms, context, pixels);
                    cells[0] = pixels.isLook() ? CellUniforms.of(uniforms, scattering) : null;
                    density[0] = pixels.isLook() ? cells[0].density() : DensityUniforms.of(uniforms);
                    tables[0] = noise == Noise.NONE ? null : NoiseTextures.Places.of(uniforms, noise == Noise.EVOLVING);
                    return new Places(uniforms.vector4("cellEdges"), uniforms.vector4("stepping"));
                });
        noisePlaces = tables[0];
        pixelUniforms = found[0];
        cellUniforms = cells[0];
        densityUniforms = density[0];
    }

    PixelUniforms pixels() {
        return pixelUniforms;
    }

    /** Returns {@code null} if the cloud's look is not drawn. */
    CellUniforms cells() {
        return cellUniforms;
    }

    DensityUniforms density() {
        return densityUniforms;
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
