package nephele.engine.render.pass.sky;

import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.Heavens;
import nephele.engine.level.appearance.Moonlight;
import nephele.engine.level.appearance.SunAndMoon;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FullScreenDrawing;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.gl.shader.Uniforms.Vector2;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.frame.FrameUniforms;

/** {@code atmosphere.frag} with its numbers, which are set when they change. */
final class SkyProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/sky/";
    /** Below the largest half float. */
    private static final double MOST_RADIANCE = 60_000;

    private final FullScreenDrawing drawing;
    private SunNumbers sunNumbers;
    private NightNumbers nightNumbers;
    private Sun sunShown;
    private Heights heightsShown;
    private Sky.Atmosphere skyShown;

    private record SunNumbers(
            Vector3 towards,
            Vector3 irradiance,
            Vector3 disc,
            Scalar discSine,
            Scalar horizon,
            Scalar horizonOfEye,
            Vector2 band,
            Scalar mieG) {}

    private record NightNumbers(
            Vector3 towardsMoon,
            Vector3 moonlight,
            Vector3 groundAlbedo,
            Vector3 equinox,
            Vector3 east,
            Vector3 pole,
            Vector3 depth) {}

    private SkyProgram(LoadContext context, boolean isNight) {
        Defines defines = Defines.of(context)
                .withIf(isNight, "NIGHT")
                .with("SKY_ROWS", SkyTable.SKY_ROWS)
                .with("GROUND_ROWS", SkyTable.GROUND_ROWS)
                .with("AZIMUTHS", SkyTable.AZIMUTHS);
        drawing = new FullScreenDrawing(
                context, defines, FOLDER, new FullScreenDrawing.Stages("sky.vert", "atmosphere.frag"), uniforms -> {
                    uniforms.sampler("skyTable", TextureUnit.COLOURS);
                    sunNumbers = new SunNumbers(
                            uniforms.vector3("towardsSun"),
                            uniforms.vector3("irradiance"),
                            uniforms.vector3("disc"),
                            uniforms.scalar("discSine"),
                            uniforms.scalar("horizon"),
                            uniforms.scalar("horizonOfEye"),
                            uniforms.vector2("band"),
                            uniforms.scalar("mieG"));
                    nightNumbers = !isNight
                            ? null
                            : new NightNumbers(
                                    uniforms.vector3("towardsMoon"),
                                    uniforms.vector3("moonlight"),
                                    uniforms.vector3("groundAlbedo"),
                                    uniforms.vector3("equinox"),
                                    uniforms.vector3("eastOfEquinox"),
                                    uniforms.vector3("northPole"),
                                    uniforms.vector3("zenithDepth"));
                });
    }

    static SkyProgram of(LoadContext context, boolean isNight) {
        return new SkyProgram(context, isNight);
    }

    /**
     * The heights of the tables and of the eye.
     *
     * @param ofTable for which the light is tabulated
     * @param ofEye where the horizon is seen from
     */
    record Heights(double ofTable, double ofEye) {}

    void sun(SunAndMoon lights, Air air, Heights heights) {
        Sun sun = lights.environment().sun();
        Vec3 towardsSun = lights.towardsSun();
        if (sun == sunShown && heights.equals(heightsShown)) {
            return;
        }
        sunShown = sun;
        heightsShown = heights;
        double heightMetres = heights.ofTable;
        set(sunNumbers.towards, towardsSun);
        set(sunNumbers.irradiance, sun.irradiance());
        set(sunNumbers.disc, disc(sun.irradiance(), towardsSun.y(), air, heightMetres));
        sunNumbers.discSine.set((float) Math.sin(air.sunRadiusRadians()));
        sunNumbers.horizon.set((float) SkyTable.horizon(heightMetres));
        sunNumbers.horizonOfEye.set((float) SkyTable.horizon(Math.min(Air.TOP_METRES, heights.ofEye)));
        sunNumbers.band.set((float) SkyTable.bandEnd(heightMetres), (float) SkyTable.bandShare(heightMetres));
        sunNumbers.mieG.set((float) air.mieG());
        if (nightNumbers != null) {
            Vec3 zenith = air.transmittance(0, 1);
            set(nightNumbers.depth, new Vec3(-Math.log(zenith.x()), -Math.log(zenith.y()), -Math.log(zenith.z())));
        }
    }

    /** Sets moon and stars of the program of the night. */
    void heavens(SunAndMoon lights) {
        Sky.Atmosphere sky = (Sky.Atmosphere) lights.environment().sky();
        Moonlight moonlight = lights.moonlight();
        set(nightNumbers.moonlight, moonlight.irradiance());
        if (sky == skyShown) {
            return;
        }
        skyShown = sky;
        Vec3[] axes = Heavens.celestialAxes(sky);
        set(nightNumbers.towardsMoon, moonlight.towardsMoon());
        Vec3 groundAlbedo = Daylight.air(sky).groundAlbedo();
        set(nightNumbers.groundAlbedo, groundAlbedo);
        set(nightNumbers.equinox, axes[0]);
        set(nightNumbers.east, axes[1]);
        set(nightNumbers.pole, axes[2]);
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

    private static void set(Vector3 uniform, Vec3 v) {
        uniform.set((float) v.x(), (float) v.y(), (float) v.z());
    }
}
