package nephele.engine.render.frame;

import java.util.Arrays;
import nephele.engine.atmosphere.AerialTable;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.AirCache;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.SunAndMoon;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.resource.ByHeight;
import nephele.engine.render.resource.FrameUniforms;
import nephele.engine.render.resource.SunAndMoonTables;
import nephele.engine.scene.View;

/**
 * The air between the eye and surfaces, for {@code air.glsl}: a table for each height from which a view is drawn. All
 * views at a height share it.
 */
public final class AerialPerspective implements GlObject {
    private final GlContext gl;
    private final SharedResources shared;
    private final boolean hasShafts;
    private final ByHeight<SunAndMoonTables> byHeight;

    private AirTables tables;
    private SunAndMoon lights;

    /** @param hasShafts whether clouds shade the air */
    AerialPerspective(GlContext gl, SharedResources shared, boolean hasShafts) {
        this.gl = gl;
        this.shared = shared;
        this.hasShafts = hasShafts;
        byHeight = new ByHeight<>(this::tables);
    }

    private SunAndMoonTables tables(double heightMetres) {
        AirTables air = tables;
        int slices = (hasShafts ? 4 : 2) * AerialTable.SLICES;
        var extent = new Texture.Extent(AerialTable.AZIMUTHS, AerialTable.ROWS, slices);
        return new SunAndMoonTables(
                new Texture(gl, "air table", Texture.Shape.VOLUME, PixelFormat.RGBA32F, extent, Sampling.LINEAR_CLAMP),
                shared.background(),
                heightMetres,
                sine -> texels(air, heightMetres, sine));
    }

    /** Returns the slices of all light, and with shafts those of light that the air scatters once after them. */
    private float[] texels(AirTables air, double heightMetres, double sine) {
        float[] all = new AerialTable(air, heightMetres, sine).texels();
        if (!hasShafts) {
            return all;
        }
        float[] once = AerialTable.ofFirstScattering(air, heightMetres, sine).texels();
        float[] both = Arrays.copyOf(all, all.length + once.length);
        System.arraycopy(once, 0, both, all.length, once.length);
        return both;
    }

    /** Returns true if surfaces of an environment are seen through air: under an atmosphere with a sun. */
    public static boolean isIn(Environment environment) {
        return environment.sky() instanceof Sky.Atmosphere && environment.sun() != null;
    }

    /** Returns true if the moon lights the air of an environment, at once or, while its sky moves, at some time. */
    static boolean isMoonlit(Environment environment) {
        return isIn(environment)
                && (Daylight.moves(environment)
                        || SunAndMoon.of(Daylight.at(environment, 0))
                                .moonlight()
                                .shines());
    }

    /** Begins a frame. */
    void follow(Environment now) {
        if (lights != null && lights.areOf(now)) {
            return;
        }
        lights = SunAndMoon.of(now);
        Air air = Daylight.air((Sky.Atmosphere) now.sky());
        if (tables == null || !air.equals(tables.air())) {
            tables = shared.shareValue(AirTables.class, air, () -> AirCache.tables(air));
            byHeight.clear();
        }
    }

    /** Sets the air of the draws in a view. */
    void setView(View view, FrameUniforms uniforms) {
        SunAndMoonTables shown =
                byHeight.near(view.eyeY(), known -> known.isReady(lights), known -> known.prepare(lights));
        shown.show(lights);
        shown.bind(TextureUnit.AIR);
        uniforms.air(shown.heightMetres(), lights);
    }

    @Override
    public void close() {
        byHeight.close();
    }
}
