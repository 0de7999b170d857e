package nephele.engine.render.resource;

import java.util.Arrays;
import nephele.engine.atmosphere.AerialTable;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.AirCache;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.ShaftLight;
import nephele.engine.level.appearance.SunAndMoon;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.scene.View;

/**
 * The air between the eye and surfaces, for {@code air.glsl}: a table for each height from which a view is drawn. All
 * views at a height share it.
 */
public final class AerialPerspective implements GlObject {
    public static final SharedResource<AerialPerspective> RESOURCE = SharedResource.of("air", AerialPerspective::of)
            .following((air, frame) -> air.follow(frame.frameState().environment()))
            .inViews(AerialPerspective::setView);

    private final LoadContext context;
    /** Whether clouds shade the air. */
    private final boolean hasShafts;

    private final HeightCache byHeight = new HeightCache(this::tables);

    private AirTables tables;
    private SunAndMoon lights;

    private AerialPerspective(LoadContext context) {
        this.context = context;
        hasShafts = ShaftLight.isIn(context.scene().level().environment());
    }

    /** Returns {@code null} without air to see through. */
    private static AerialPerspective of(LoadContext context) {
        boolean isLit = SunAndMoon.lightAir(context.scene().level().environment());
        return isLit ? context.own(new AerialPerspective(context)) : null;
    }

    private SunAndMoonTables tables(double heightMetres) {
        AirTables air = tables;
        int slices = (hasShafts ? 4 : 2) * AerialTable.SLICES;
        var extent = new Texture.Extent(AerialTable.AZIMUTHS, AerialTable.ROWS, slices);
        return new SunAndMoonTables(
                new Texture(
                        context.gl(),
                        "air table",
                        Texture.Shape.VOLUME,
                        PixelFormat.RGBA32F,
                        extent,
                        Sampling.LINEAR_CLAMP),
                context.get(SunAndMoonTables.THREADS),
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

    private void follow(Environment now) {
        if (lights != null && lights.areOf(now)) {
            return;
        }
        lights = SunAndMoon.of(now);
        Air air = Daylight.air((Sky.Atmosphere) now.sky());
        if (tables == null || !air.equals(tables.air())) {
            tables = context.shareValue(AirTables.class, air, () -> AirCache.tables(air));
            byHeight.clear();
        }
    }

    /** Sets the air of the draws in a view. */
    private void setView(View view) {
        SunAndMoonTables near = byHeight.near(view.eyeY(), lights);
        near.show(lights);
        near.bind(TextureUnit.AIR);
        context.resources().uniforms().air(near.heightMetres(), lights);
    }

    @Override
    public void close() {
        byHeight.close();
    }
}
