package nephele.engine.render.pass.cloud;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.gl.shader.Uniforms.Vector2;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;

/**
 * The programs that draw clouds by a pair of shaders, one for each kind of pixels, compiled when it is first drawn. Clouds
 * that need equal programs share them, as everything in a context does. Each reads some of the {@link Shared} uniforms besides
 * its own.
 *
 * @param <U> the uniforms of each
 */
public final class CloudPrograms<U extends Record> {
    private static final String FOLDER = "/nephele/engine/render/pass/cloud/";

    /** Boxes that a cloud has at most; {@code MOST_BOXES} in shaders. */
    private static final int MOST_BOXES = 6;

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
                .withIf(pixels.isBeforeSurfaces(), "BEFORE_SURFACES")
                .withIf(pixels == CloudPixels.CAPTURED, "CAPTURED")
                .withIf(pixels == CloudPixels.FLASH, "BY_FLASH")
                .withIf(pixels == CloudPixels.BOLT, "OF_BOLT")
                .with("FLASH_LIGHTS", CloudCanvas.FLASH_LIGHTS)
                .withIf(pixels == CloudPixels.BAKED, "BAKED")
                .withIf(pixels.isShared(), "SHARED")
                .with("MOST_BOXES", MOST_BOXES);
        return GlProgram.of(
                context.load().gl(), vertex, fragment, choices.apply(defines).values(), uniforms);
    }

    /**
     * The uniforms that programs of clouds share; each program reads some of them. {@link CloudCanvas} sets those of {@code
     * cloud-pixel.glsl}, where and what is drawn; {@link LitCloud} those of {@code cloud-light.glsl} and {@code cell-boxes.glsl},
     * the cloud and its light.
     */
    public record Shared(
            @IfRead Vector2 layerStep,
            @IfRead Vector3 marchedSquare,
            @IfRead Vector3 blown,
            @IfRead Scalar capturedPlane,
            @IfRead Vector3 cut,
            @IfRead Scalar cloudFraction,
            @IfRead Vector3 boltFromEye,
            @IfRead List<Vector4> flashLights,
            @IfRead Vector3 flashIntensity,
            @IfRead Boxes nested,
            @IfRead Vector4 medium,
            @IfRead Vector4 phase,
            @IfRead Vector3 cloudSun,
            @IfRead Vector4 diffuseAxis,
            @IfRead Vector3 irradiance,
            @IfRead Vector3 skyAbove,
            @IfRead Vector3 skyBelow) {}

    /** The uniforms of {@code cell-boxes.glsl}: nested boxes of cells around a focus. */
    public record Boxes(List<Vector4> boxes, Vector4 cells, Vector3 cloudBase, Vector3 cloudHalf) {
        /** Sets the place of a box. @param eye in the space of the boxes */
        public void put(int level, Aabb box, Vec3 eye) {
            Vec3 middle = box.centre().minus(eye);
            boxes.get(level).set(middle.x(), middle.z(), 1 / (box.maxX() - box.minX()), 1 / (box.maxZ() - box.minZ()));
        }

        /**
         * Sets the heights of the boxes and how far the narrowest one serves.
         *
         * @param middle of what the boxes are around, relative to the eye
         * @param reachX distance from it, metres; {@code reachZ} likewise
         */
        public void put(Aabb narrowest, Vec3 eye, Vec3 middle, double reachX, double reachZ) {
            cloudBase.set(middle.x(), narrowest.minY() - eye.y(), middle.z());
            cloudHalf.set(reachX, narrowest.maxY() - narrowest.minY(), reachZ);
        }
    }
}
