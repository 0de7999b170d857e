package nephele.engine.render.pass.shadow;

import java.util.Map;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
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
import nephele.engine.scene.light.ShadowFrame;

/** Draws the depth of billboards with edges into the sun's picture, turned to the sun as they are to an eye. */
final class BillboardDepth {
    private static final String FOLDER = "/nephele/engine/render/pass/shadow/";

    private record SunUniforms(
            Uniforms.Matrix4 clipFromAnchor, Uniforms.Vector3 towardsSun, Uniforms.Vector3 mapRight) {}

    private final GlContext gl;
    private final BillboardQuads quads;
    private final BillboardList list;
    private final GlProgram<SunUniforms> program;

    BillboardDepth(LoadContext context) {
        gl = context.gl();
        quads = context.billboards(Kind.WITH_EDGES);
        list = context.own(new BillboardList(gl));
        program = new GlProgram<>(
                gl,
                ShaderSource.load(
                        FOLDER + "billboard-depth.vert",
                        Map.of("PER_SHEET", Integer.toString(BillboardList.PER_SHEET))),
                ShaderSource.load(FOLDER + "billboard-depth.frag", Map.of()),
                uniforms -> {
                    BillboardQuads.tie(uniforms);
                    return new SunUniforms(
                            uniforms.matrix4("clipFromAnchor"),
                            uniforms.vector3("towardsSun"),
                            uniforms.vector3("mapRight"));
                });
    }

    /** Draws into the bound target. @param direction towards the sun, any length */
    void draw(ShadowFrame frame, Vec3 direction) {
        quads.follow(0);
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.NONE);
        program.use();
        Vec3 towards = Directions.unit(direction);
        program.uniforms().clipFromAnchor().set(frame.clipFromAnchor().get(new float[16]));
        program.uniforms().towardsSun().set((float) towards.x(), (float) towards.y(), (float) towards.z());
        Vec3 right = frame.right();
        program.uniforms().mapRight().set((float) right.x(), (float) right.y(), (float) right.z());
        quads.bind();
        list.draw(quads.clusters(), quads);
    }
}
