package nephele.engine.render.frame;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.resource.FrameUniforms;
import nephele.engine.scene.View;

/**
 * The air between the eye and surfaces, for {@code air.glsl}: a table for each height from which a view is drawn. All
 * views at a height share it.
 */
public final class AerialPerspective implements GlObject {
    /** Views through openings may be at other heights than the eye. */
    private static final int MOST_HEIGHTS = 4;

    private final GlContext gl;
    private final SharedResources shared;
    /** The one that was used last is the last. */
    private final List<AerialTexture> byHeight = new ArrayList<>();

    private AirTables tables;
    private Sky.Atmosphere sky;
    private Sun sun;
    private Vec3 towardsSun;

    AerialPerspective(GlContext gl, SharedResources shared) {
        this.gl = gl;
        this.shared = shared;
    }

    /** Returns true if surfaces of an environment are seen through air: under an atmosphere with a sun. */
    public static boolean isIn(Environment environment) {
        return environment.sky() instanceof Sky.Atmosphere && environment.sun() != null;
    }

    /** Returns the height for which the light of the sky is tabulated instead of that of the eye. */
    public static double shelf(double heightMetres) {
        double near = Math.max(0, heightMetres);
        return near < 50 ? 2 : Math.exp(Math.round(Math.log(near) * 50) / 50.0);
    }

    /** Begins a frame. */
    void follow(Environment now) {
        if (now.sky() == sky && now.sun() == sun) {
            return;
        }
        sky = (Sky.Atmosphere) now.sky();
        sun = now.sun();
        towardsSun = Directions.unit(sun.directionTowardsSun());
        if (tables == null || !Daylight.air(sky).equals(tables.air())) {
            tables = shared.shareValue(AirTables.class, Daylight.air(sky), () -> AirTables.of(Daylight.air(sky)));
            byHeight.forEach(GlObject::close);
            byHeight.clear();
        }
    }

    /** Sets the air of the draws in a view. */
    void setView(View view, FrameUniforms uniforms) {
        AerialTexture texture = at(shelf(view.eyeY()));
        texture.follow(tables, towardsSun.y(), sky.dayLengthSeconds() > 0);
        texture.bind(TextureUnit.AIR);
        uniforms.air(texture.table(), towardsSun, sun.irradiance());
    }

    private AerialTexture at(double heightMetres) {
        for (int i = byHeight.size() - 1; i >= 0; i--) {
            if (byHeight.get(i).heightMetres() == heightMetres) {
                byHeight.add(byHeight.remove(i));
                return byHeight.get(byHeight.size() - 1);
            }
        }
        if (byHeight.size() == MOST_HEIGHTS) {
            byHeight.remove(0).close();
        }
        byHeight.add(new AerialTexture(gl, heightMetres));
        return byHeight.get(byHeight.size() - 1);
    }

    @Override
    public void close() {
        byHeight.forEach(GlObject::close);
    }
}
