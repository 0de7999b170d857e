package nephele.engine.render.pass.shadow;

import java.util.Map;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.BillboardList;
import nephele.engine.render.resource.BillboardQuads;
import nephele.engine.render.resource.BillboardSource.Kind;
import nephele.engine.render.resource.SquareSheet;
import nephele.engine.scene.light.ShadowFrame;

/** Draws the depth of billboards with edges into the sun's picture, turned to the sun as they are to an eye, or to the level's observer. */
final class BillboardDepth {
    private static final String FOLDER = "/nephele/engine/render/pass/shadow/";

    /** Either the sun's or the observer's uniforms are {@code null}. */
    private record SunUniforms(
            Uniforms.Matrix4 clipFromAnchor,
            Uniforms.Vector3 towardsSun,
            Uniforms.Vector3 mapRight,
            Uniforms.Vector3 observer) {}

    private final GlContext gl;
    private final BillboardQuads quads;
    private final BillboardList list;
    private final GlProgram<SunUniforms> program;

    BillboardDepth(LoadContext context) {
        gl = context.gl();
        quads = BillboardQuads.of(context, Kind.WITH_EDGES);
        list = context.own(new BillboardList(gl, 1));
        boolean isObserved = context.scene().level().observerStart() != null;
        Map<String, String> defines = new Defines()
                .with("PER_SHEET", BillboardList.PER_SHEET)
                .with("VERTICES", SquareSheet.vertices(1))
                .withIf(isObserved, "OBSERVER")
                .values();
        program = new GlProgram<>(
                gl,
                ShaderSource.load(FOLDER + "billboard-depth.vert", defines),
                ShaderSource.load(FOLDER + "billboard-depth.frag", Map.of()),
                uniforms -> {
                    BillboardQuads.tie(uniforms);
                    return new SunUniforms(
                            uniforms.matrix4("clipFromAnchor"),
                            isObserved ? null : uniforms.vector3("towardsSun"),
                            isObserved ? null : uniforms.vector3("mapRight"),
                            isObserved ? uniforms.vector3("observer") : null);
                });
    }

    /**
     * Draws into the bound target.
     *
     * @param direction towards the sun, any length
     * @param observer the place that they face; {@code null} if they face the sun
     */
    void draw(ShadowFrame frame, Vec3 direction, Vec3 observer) {
        quads.follow(0);
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.NONE);
        program.use();
        program.uniforms().clipFromAnchor().set(frame.clipFromAnchor().get(new float[16]));
        if (program.uniforms().observer() != null && observer != null) {
            set(program.uniforms().observer(), observer.minus(frame.anchor()));
        } else if (program.uniforms().observer() == null) {
            set(program.uniforms().towardsSun(), Directions.unit(direction));
            set(program.uniforms().mapRight(), frame.right());
        }
        quads.bind();
        list.draw(quads.clusters(), quads);
    }

    private static void set(Uniforms.Vector3 uniform, Vec3 value) {
        uniform.set((float) value.x(), (float) value.y(), (float) value.z());
    }
}
