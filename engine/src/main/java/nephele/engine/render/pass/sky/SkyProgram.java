package nephele.engine.render.pass.sky;

import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.CelestialPositions;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.Moonlight;
import nephele.engine.level.appearance.SunAndMoon;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FullScreenDrawing;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.gl.shader.Uniforms.Vector2;
import nephele.engine.render.gl.shader.Uniforms.Vector3;

/** {@code atmosphere.frag} with its numbers, which are set when they change. */
final class SkyProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/sky/";
    /** Below the largest half float. */
    private static final double MOST_RADIANCE = 60_000;

    private final FullScreenDrawing drawing;
    private final Numbers numbers;
    private final boolean isNight;
    private Sun drawnSun;
    private double drawnTableMetres;
    private double drawnEyeMetres;
    private Sky.Atmosphere drawnSky;

    private record Numbers(
            Vector3 towardsSun,
            Vector3 irradiance,
            Vector3 disc,
            Scalar discSine,
            Scalar horizon,
            Scalar horizonOfEye,
            Vector2 band,
            Scalar mieG,
            @IfRead Vector3 towardsMoon,
            @IfRead Vector3 moonlight,
            @IfRead Vector3 groundAlbedo,
            @IfRead Vector3 equinox,
            @IfRead Vector3 eastOfEquinox,
            @IfRead Vector3 northPole,
            @IfRead Vector3 zenithDepth) {}

    SkyProgram(LoadContext context, boolean isNight) {
        this.isNight = isNight;
        Defines defines = Defines.of(context)
                .withIf(isNight, "NIGHT")
                .with("SKY_ROWS", SkyTable.SKY_ROWS)
                .with("GROUND_ROWS", SkyTable.GROUND_ROWS)
                .with("AZIMUTHS", SkyTable.AZIMUTHS);
        drawing = new FullScreenDrawing(context, defines, FOLDER + "sky.vert", FOLDER + "atmosphere.frag");
        numbers = drawing.uniforms(Numbers.class);
    }

    /**
     * Sets the sun and the air.
     *
     * @param tableMetres height for which the light is tabulated
     * @param eyeMetres height where the horizon is visible from
     */
    void sun(SunAndMoon lights, Air air, double tableMetres, double eyeMetres) {
        Sun sun = lights.environment().sun();
        Vec3 towardsSun = lights.towardsSun();
        if (sun == drawnSun && tableMetres == drawnTableMetres && eyeMetres == drawnEyeMetres) {
            return;
        }
        drawnSun = sun;
        drawnTableMetres = tableMetres;
        drawnEyeMetres = eyeMetres;
        numbers.towardsSun.set(towardsSun);
        numbers.irradiance.set(sun.irradiance());
        numbers.disc.set(disc(sun.irradiance(), towardsSun.y(), air, tableMetres));
        numbers.discSine.set((float) Math.sin(air.sunRadiusRadians()));
        numbers.horizon.set((float) SkyTable.horizon(tableMetres));
        numbers.horizonOfEye.set((float) SkyTable.horizon(Math.min(Air.TOP_METRES, eyeMetres)));
        numbers.band.set((float) SkyTable.bandEnd(tableMetres), (float) SkyTable.bandShare(tableMetres));
        numbers.mieG.set((float) air.mieG());
        if (isNight) {
            Vec3 zenith = air.transmittance(0, 1);
            numbers.zenithDepth.set(-Math.log(zenith.x()), -Math.log(zenith.y()), -Math.log(zenith.z()));
        }
    }

    /** Sets moon and stars of the program of the night. */
    void heavens(SunAndMoon lights) {
        Sky.Atmosphere sky = (Sky.Atmosphere) lights.environment().sky();
        Moonlight moonlight = lights.moonlight();
        numbers.moonlight.set(moonlight.irradiance());
        if (sky == drawnSky) {
            return;
        }
        drawnSky = sky;
        Vec3[] axes = CelestialPositions.celestialAxes(sky);
        numbers.towardsMoon.set(moonlight.towardsMoon());
        numbers.groundAlbedo.set(Daylight.air(sky).groundAlbedo());
        numbers.equinox.set(axes[0]);
        numbers.eastOfEquinox.set(axes[1]);
        numbers.northPole.set(axes[2]);
    }

    /** Returns the mean radiance of the disc; black for a point. */
    private static Vec3 disc(Vec3 outside, double sunSine, Air air, double heightMetres) {
        if (air.sunRadiusRadians() == 0) {
            return Vec3.ZERO;
        }
        double horizon = Math.sin(SkyTable.horizonRadians(heightMetres));
        Vec3 dimmed = air.transmittance(heightMetres, Math.max(horizon + 1e-6, sunSine));
        double steradians = Math.PI * air.sunRadiusRadians() * air.sunRadiusRadians();
        return new Vec3(
                Math.min(MOST_RADIANCE, outside.x() * dimmed.x() / steradians),
                Math.min(MOST_RADIANCE, outside.y() * dimmed.y() / steradians),
                Math.min(MOST_RADIANCE, outside.z() * dimmed.z() / steradians));
    }

    void draw(RenderTarget target) {
        drawing.draw(target, Depth.LESS_OR_EQUAL);
    }
}
