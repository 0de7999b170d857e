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
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.resource.BillboardList;
import nephele.engine.render.resource.BillboardQuads;
import nephele.engine.render.resource.BillboardQuads.Kind;
import nephele.engine.render.resource.SquareSheet;
import nephele.engine.scene.light.ShadowFrame;

/** Draws the depth of billboards with edges into the sun's picture, turned to the sun as they are to an eye, or to the level's observer. */
final class BillboardDepth {
    private static final String FOLDER = "/nephele/engine/render/pass/shadow/";

    private record SunUniforms(
            Uniforms.Matrix4 clipFromAnchor,
            @IfRead Uniforms.Vector3 towardsSun,
            @IfRead Uniforms.Vector3 mapRight,
            @IfRead Uniforms.Vector3 observer) {}

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
        program = GlProgram.of(
                gl, FOLDER + "billboard-depth.vert", FOLDER + "billboard-depth.frag", defines, SunUniforms.class);
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
        if (observer != null) {
            program.uniforms().observer().set(observer.minus(frame.anchor()));
        }
        program.uniforms().towardsSun().set(Directions.unit(direction));
        program.uniforms().mapRight().set(frame.right());
        quads.bind();
        list.draw(quads.clusters(), quads);
    }
}
