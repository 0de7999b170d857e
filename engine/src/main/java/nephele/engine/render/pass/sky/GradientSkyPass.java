package nephele.engine.render.pass.sky;

import java.util.List;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.FogVeil;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.FullScreenDrawing;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.Uniforms;

/** Zenith, horizon and ground blended by altitude, where no solid has been drawn. Nothing is seen of it through fog. */
public final class GradientSkyPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("sky.gradient", GradientSkyPass::requiredBy);

    private static final String FOLDER = "/nephele/engine/render/pass/sky/";

    private final Sky.Gradient sky;
    private final FullScreenDrawing drawing;

    private GradientSkyPass(GlContext gl, Sky.Gradient sky) {
        this.sky = sky;
        drawing = new FullScreenDrawing(gl, "gradient sky");
    }

    private static List<Required> requiredBy(FrameRequest request) {
        Environment environment = request.level().environment();
        Sky sky = environment.sky();
        if (FogVeil.of(environment).isPresent()) {
            return List.of();
        } else if (sky instanceof Sky.Gradient gradient) {
            return List.of(new Required("environment.sky: a gradient", gl -> new GradientSkyPass(gl, gradient)));
        } else if (sky instanceof Sky.Atmosphere) {
            return List.of(new Required(
                    "environment.sky: an atmosphere, shown as a gradient because scattering is not computed yet",
                    gl -> new GradientSkyPass(gl, GradientSky.ATMOSPHERE_STAND_IN)));
        }
        return List.of();
    }

    @Override
    public Stage stage() {
        return Stage.IN_VIEWS;
    }

    @Override
    public boolean isSky() {
        return true;
    }

    @Override
    public void load(LoadContext context) {
        drawing.load(context, FOLDER, new FullScreenDrawing.Stages("sky.vert", "gradient.frag"), this::setUniforms);
    }

    private Object setUniforms(Uniforms uniforms) {
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
        drawing.draw(frame.surface(), Depth.LESS_OR_EQUAL);
    }

    @Override
    public void close() {
        drawing.close();
    }
}
