package nephele.engine.render.pass.sky;

import java.util.List;
import java.util.Set;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameUniforms;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.ShaderSource;
import nephele.engine.render.gl.Uniforms;

/** Zenith, horizon and ground blended by altitude, where no solid has been drawn. */
public final class GradientSkyPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("sky.gradient", GradientSkyPass::requiredBy);

    private static final String FOLDER = "/nephele/engine/render/pass/sky/";

    private final GlContext gl;
    private final Sky.Gradient sky;
    private final FullScreenTriangle triangle;
    private GlProgram<Object> program;

    private GradientSkyPass(GlContext gl, Sky.Gradient sky) {
        this.gl = gl;
        this.sky = sky;
        this.triangle = new FullScreenTriangle(gl, "gradient sky");
    }

    private static List<Required> requiredBy(Level level) {
        Sky sky = level.environment().sky();
        if (sky instanceof Sky.Gradient gradient) {
            return List.of(new Required("environment.sky: a gradient", gl -> new GradientSkyPass(gl, gradient)));
        } else if (sky instanceof Sky.Atmosphere) {
            return List.of(new Required(
                    "environment.sky: an atmosphere, shown as a gradient because scattering is not computed yet",
                    gl -> new GradientSkyPass(gl, GradientSky.ATMOSPHERE_STAND_IN)));
        }
        return List.of();
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.SURFACE);
    }

    @Override
    public void load(LoadContext context) {
        var defines = Defines.of(context).values();
        program = new GlProgram<>(
                gl,
                ShaderSource.load(FOLDER + "sky.vert", defines),
                ShaderSource.load(FOLDER + "gradient.frag", defines),
                this::setUniforms);
    }

    private Object setUniforms(Uniforms uniforms) {
        uniforms.block("Frame", FrameUniforms.BINDING);
        set(uniforms.vector3("zenith"), sky.zenith());
        set(uniforms.vector3("horizon"), sky.horizon());
        set(uniforms.vector3("ground"), sky.ground());
        return uniforms;
    }

    private static void set(Uniforms.Vector3 uniform, Vec3 v) {
        uniform.set((float) v.x(), (float) v.y(), (float) v.z());
    }

    @Override
    public void draw(FrameContext frame) {
        frame.surface().bind();
        gl.state().set(Depth.LESS_OR_EQUAL, Blend.REPLACE, Cull.NONE);
        program.use();
        triangle.draw();
    }

    @Override
    public void close() {
        triangle.close();
        if (program != null) {
            program.close();
        }
    }
}
