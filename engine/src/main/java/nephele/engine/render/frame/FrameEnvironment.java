package nephele.engine.render.frame;

import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.level.appearance.LuminanceHistogram;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;

/** Values derived from a frame's environment for all views; derived again when the environment has changed. */
public final class FrameEnvironment {
    private final Output output;
    private Environment environment;
    private Vec3 clearColour;
    private double exposure;

    FrameEnvironment(Output output) {
        this.output = output;
    }

    void follow(Environment now) {
        if (now != environment) {
            environment = now;
            exposure = Math.pow(2, now.exposureStops().stopsOr(0));
            clearColour = stored(background());
        }
    }

    /** Returns the factor on radiance before the tone curve; 1 for auto, which is metered. */
    public double exposure() {
        return exposure;
    }

    /** Returns the colour behind everything as it is stored: a constant sky and fog without end need no pass. */
    public Vec3 clearColour() {
        return clearColour;
    }

    /** Returns the colour behind everything in a view that mirrors tint. */
    public Vec3 clearColour(View view) {
        return view.isTinted() ? stored(background().times(Vec3.of(view.tint()))) : clearColour;
    }

    private Vec3 background() {
        if (FogTransmittance.hidesSky(environment)) {
            return environment.fog().radiance();
        }
        return environment.sky() instanceof Sky.Constant constant ? constant.radiance() : Vec3.ZERO;
    }

    private Vec3 stored(Vec3 radiance) {
        return new Vec3(stored(radiance.x()), stored(radiance.y()), stored(radiance.z()));
    }

    private double stored(double radiance) {
        return switch (output) {
            case PLAIN -> radiance;
            case HDR -> Math.min(radiance, LuminanceHistogram.LARGEST_HALF);
            case DIRECT -> ToneMapping.displayValue(radiance, exposure, environment.toneCurve());
        };
    }
}
