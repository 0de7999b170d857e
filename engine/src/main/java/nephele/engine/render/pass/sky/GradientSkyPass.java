package nephele.engine.render.pass.sky;

import java.util.List;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.FullScreenDrawing;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.RenderFeature.Role;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.shader.Uniforms.Vector3;

/**
 * Draws a gradient of zenith, horizon and ground by altitude where no solid has been drawn; behind fog that ends with
 * altitude a sky of one radiance, too.
 */
public final class GradientSkyPass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("sky.gradient", Stage.IN_VIEWS, Role.SKY, GradientSkyPass::requiredBy);

    private static final String FOLDER = "/nephele/engine/render/pass/sky/";

    private final FullScreenDrawing drawing;
    private final Colours colours;

    private record Colours(Vector3 zenith, Vector3 horizon, Vector3 ground) {}

    private GradientSkyPass(LoadContext context) {
        drawing = new FullScreenDrawing(context, Defines.of(context), FOLDER + "sky.vert", FOLDER + "gradient.frag");
        colours = drawing.uniforms(Colours.class);
    }

    private static List<Required> requiredBy(FrameRequest request) {
        Environment environment = request.level().environment();
        Sky sky = environment.sky();
        if (FogTransmittance.hidesSky(environment)) {
            return List.of();
        }
        if (sky instanceof Sky.Gradient) {
            return List.of(new Required("environment.sky: a gradient", GradientSkyPass::new));
        }
        boolean isFogBefore = FogTransmittance.of(environment).isPresent() && isEven(environment);
        return isFogBefore
                ? List.of(new Required(
                        "environment.fog: its share of the sky changes with altitude", GradientSkyPass::new))
                : List.of();
    }

    /** Returns true if the sky has one radiance. */
    private static boolean isEven(Environment environment) {
        Sky sky = environment.sky();
        return sky == null || sky instanceof Sky.Constant || sky instanceof Sky.Atmosphere && environment.sun() == null;
    }

    private static Sky.Gradient gradient(Sky sky) {
        if (sky instanceof Sky.Gradient gradient) {
            return gradient;
        }
        Vec3 even = sky instanceof Sky.Constant constant ? constant.radiance() : Vec3.ZERO;
        return new Sky.Gradient(even, even, even);
    }

    @Override
    public void draw(FrameContext frame) {
        Sky.Gradient sky = gradient(frame.frameState().environment().sky());
        colours.zenith.set(sky.zenith());
        colours.horizon.set(sky.horizon());
        colours.ground.set(sky.ground());
        drawing.draw(frame.surface(), Depth.LESS_OR_EQUAL);
    }
}
