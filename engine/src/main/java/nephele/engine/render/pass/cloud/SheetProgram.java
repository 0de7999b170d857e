package nephele.engine.render.pass.cloud;

import java.util.function.Function;
import nephele.engine.cloud.cells.CellStack;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;

/**
 * A program that draws clouds as sheets with {@code cloud-sheet.glsl}.
 *
 * @param <P> the places of what else it has
 */
public final class SheetProgram<P> {
    private static final String FOLDER = "/nephele/engine/render/pass/cloud/";

    private final GlProgram<Places<P>> program;

    /** @param sheet the eye's height over a round planet and the longest way through the cloud, metres */
    private record Places<P>(PixelUniforms pixels, CellUniforms cells, Uniforms.Vector2 sheet, P own) {}

    /**
     * Compiles a program.
     *
     * @param fragments file in the folder of clouds
     * @param ownDefines added to those of all sheets
     * @param own finds the places of what else it has
     */
    public SheetProgram(
            CloudContext context,
            CloudPixels pixels,
            String fragments,
            Function<Defines, Defines> ownDefines,
            Function<Uniforms, P> own) {
        CloudScattering scattering = context.load().quality().cloudScattering();
        var defines = ownDefines
                .apply(PixelUniforms.defines(context, pixels)
                        .withIf(scattering == CloudScattering.OCTAVES, "OCTAVES")
                        .with("MOST_BOXES", DensityUniforms.MOST_BOXES))
                .values();
        program = new GlProgram<>(
                context.load().gl(),
                ShaderSource.load(FOLDER + "cloud.vert", defines),
                ShaderSource.load(FOLDER + fragments, defines),
                uniforms -> {
                    return new Places<>(
                            PixelUniforms.of(uniforms, context, pixels),
                            CellUniforms.of(uniforms, scattering),
                            uniforms.vector2("sheet"),
                            own.apply(uniforms));
                });
    }

    /** Uses it for a cloud; what else it has is left to be set. */
    P use(CloudCanvas canvas, PlacedCloud placed, LitCloud lit) {
        program.use();
        Places<P> places = program.uniforms();
        canvas.put(places.pixels, placed);
        lit.put(places.cells, canvas.view(), canvas.focus());
        places.sheet.set((float) canvas.view().eyeY(), (float) longestWay(lit));
        return places.own;
    }

    private static double longestWay(LitCloud lit) {
        CellStack cells = lit.shown().cells();
        Aabb box = cells.narrowest().box();
        return cells.isLayer()
                ? Float.MAX_VALUE
                : new Vec3(box.maxX(), box.maxY(), box.maxZ())
                        .minus(new Vec3(box.minX(), box.minY(), box.minZ()))
                        .length();
    }
}
