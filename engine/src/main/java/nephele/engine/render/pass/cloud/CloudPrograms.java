package nephele.engine.render.pass.cloud;

import java.util.EnumMap;
import java.util.Map;
import java.util.function.UnaryOperator;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.gl.GlProgram;

/**
 * The programs that draw clouds by a pair of shaders, one for each kind of pixels, compiled when it is first drawn. Clouds
 * that need equal programs share them, as everything in a context does.
 *
 * @param <U> the uniforms of each
 */
public final class CloudPrograms<U extends Record> {
    private static final String FOLDER = "/nephele/engine/render/pass/cloud/";

    private final CloudContext context;
    private final String vertex;
    private final String fragment;
    private final UnaryOperator<Defines> choices;
    private final Class<U> uniforms;
    private final Map<CloudPixels, GlProgram<U>> compiled = new EnumMap<>(CloudPixels.class);

    /**
     * @param vertex path of a shader in the folder of clouds; {@code fragment} likewise
     * @param choices adds definitions
     */
    public CloudPrograms(
            CloudContext context, String vertex, String fragment, UnaryOperator<Defines> choices, Class<U> uniforms) {
        this.context = context;
        this.vertex = FOLDER + vertex;
        this.fragment = FOLDER + fragment;
        this.choices = choices;
        this.uniforms = uniforms;
    }

    /** Makes the program for some pixels the current one and returns its uniforms. */
    public U use(CloudPixels pixels) {
        GlProgram<U> program = compiled.computeIfAbsent(pixels, this::compile);
        program.use();
        return program.uniforms();
    }

    private GlProgram<U> compile(CloudPixels pixels) {
        Defines defines = Defines.of(context.load())
                .withIf(pixels.isGrid(), "WHOLE")
                .withIf(pixels == CloudPixels.CAPTURED, "CAPTURED")
                .withIf(pixels == CloudPixels.FLASH, "BY_FLASH")
                .withIf(pixels == CloudPixels.BOLT, "OF_BOLT")
                .with("FLASH_LIGHTS", CloudCanvas.FLASH_LIGHTS)
                .withIf(pixels == CloudPixels.MIXED, "MIXED")
                .withIf(pixels == CloudPixels.BAKED, "BAKED")
                .withIf(pixels.isShared(), "SHARED")
                .with("CLOUDS", context.ranges())
                .with("MOST_BOXES", CloudUniforms.MOST_BOXES);
        return GlProgram.of(
                context.load().gl(), vertex, fragment, choices.apply(defines).values(), uniforms);
    }
}
