package nephele.engine.render.frame;

import nephele.engine.atmosphere.AirTables;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.AirCache;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.resource.AerialTexture;
import nephele.engine.render.resource.ByHeight;
import nephele.engine.render.resource.FrameUniforms;
import nephele.engine.scene.View;

/**
 * The air between the eye and surfaces, for {@code air.glsl}: a table for each height from which a view is drawn. All
 * views at a height share it.
 */
public final class AerialPerspective implements GlObject {
    private final SharedResources shared;
    private final ByHeight<AerialTexture> byHeight;

    private AirTables tables;
    private Environment environment;
    private Sky.Atmosphere sky;
    private Sun sun;
    private Vec3 towardsSun;

    AerialPerspective(GlContext gl, SharedResources shared) {
        this.shared = shared;
        byHeight = new ByHeight<>(height -> new AerialTexture(gl, shared.background(), tables, height));
    }

    /** Returns true if surfaces of an environment are seen through air: under an atmosphere with a sun. */
    public static boolean isIn(Environment environment) {
        return environment.sky() instanceof Sky.Atmosphere && environment.sun() != null;
    }

    /** Begins a frame. */
    void follow(Environment now) {
        if (now.sky() == sky && now.sun() == sun) {
            return;
        }
        environment = now;
        sky = (Sky.Atmosphere) now.sky();
        sun = now.sun();
        towardsSun = Directions.unit(sun.directionTowardsSun());
        if (tables == null || !Daylight.air(sky).equals(tables.air())) {
            tables = shared.shareValue(AirTables.class, Daylight.air(sky), () -> AirCache.tables(Daylight.air(sky)));
            byHeight.clear();
        }
    }

    /** Sets the air of the draws in a view. */
    void setView(View view, FrameUniforms uniforms) {
        boolean isMoving = Daylight.moves(environment);
        AerialTexture texture =
                byHeight.near(view.eyeY(), known -> known.sun().isReady(towardsSun.y(), isMoving), known -> known.sun()
                        .prepare(towardsSun.y()));
        if (isMoving) {
            texture.sun().follow(towardsSun.y(), seconds -> Daylight.sunSineAfter(environment, seconds));
        } else {
            texture.sun().show(towardsSun.y());
        }
        texture.bind(TextureUnit.AIR);
        uniforms.air(texture.heightMetres(), towardsSun, sun.irradiance());
    }

    @Override
    public void close() {
        byHeight.close();
    }
}
