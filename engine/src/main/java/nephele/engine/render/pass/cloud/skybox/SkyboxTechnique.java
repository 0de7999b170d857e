package nephele.engine.render.pass.cloud.skybox;

import java.util.List;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import nephele.engine.model.BoundingSphere;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.gl.shader.Uniforms.Vector2;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.render.pass.cloud.CloudCanvas;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudPrograms;
import nephele.engine.render.pass.cloud.CloudUniforms;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.render.resource.RendererClouds;
import nephele.engine.scene.View;

/**
 * Draws a cloud by pictures around one point, which another technique has drawn; the wind moves them as what is as far as its
 * middle. If parts of it are elsewhere by a texel, or its light has changed, since they were drawn, the next ones are drawn,
 * one a frame, and then fade in for as long as that has taken. After a jump in time all are drawn at once.
 */
public final class SkyboxTechnique implements CloudDrawing {
    /** A longer time between two frames is a jump. */
    private static final double JUMP_SECONDS = 1;

    private static final double SHORTEST_FADE_SECONDS = 0.5;
    private static final double LONGEST_FADE_SECONDS = 10;
    /** Motion from which on pictures are drawn again. */
    private static final double MOST_TEXELS = 1;

    private static final double MOST_SUN_RADIANS = Math.toRadians(2);
    private static final double MOST_PRESENCE = 1.0 / 16;
    private static final Vec3 EYE_OVER_FEET = new Vec3(0, 1.65, 0);

    private final RendererClouds clouds;
    private final PlacedCloud placed;
    private final SkyBaker baker;
    private final CloudPrograms<SkyUniforms> programs;
    private final FullScreenTriangle triangle;
    /** Metres a second by which a shape that evolves counts as moving: a billow in each generation. */
    private final double evolutionSpeed;

    private SkyPicture drawn;
    /** The pictures that fade out, or that are drawn next. */
    private SkyPicture other;

    private Environment environment;
    private CloudInterval now;
    private CloudInterval handled;
    private int cuts;
    private double fadeStart;
    private double fadeSeconds;
    private double fade = 1;

    private record SkyUniforms(
            CloudUniforms cloud,
            List<Vector3> skyAxes,
            List<Vector3> skyLayers,
            List<Vector2> skyHalf,
            List<Vector4> skyWind,
            Vector3 skyLayer,
            Scalar fade) {}

    private SkyboxTechnique(CloudContext context, PlacedCloud placed, Technique baked) {
        LoadContext load = context.load();
        clouds = load.get(RendererClouds.RESOURCE);
        this.placed = placed;
        PlacedCloud still = placed.again();
        baker = new SkyBaker(load, still, baked.build().apply(context, still), bakePoint(load, still));
        programs =
                new CloudPrograms<>(context, "cloud.vert", "skybox/skybox.frag", defines -> defines, SkyUniforms.class);
        triangle = load.own(new FullScreenTriangle(load.gl(), "skybox of clouds"));
        drawn = load.own(new SkyPicture(load.gl()));
        other = load.own(new SkyPicture(load.gl()));
        evolutionSpeed = placed.source().evolves()
                        && placed.source().cloud().density() instanceof Cloud.Density.Noise noise
                ? noise.featureMetres() / placed.source().cloud().motion().evolutionSeconds()
                : 0;
    }

    /** @param baked the technique that draws the pictures */
    public static Technique registered(Technique baked) {
        return new Technique(
                CloudTechnique.SKYBOX,
                baked.canDraw(),
                (context, placed) -> new SkyboxTechnique(context, placed, baked));
    }

    /**
     * Returns the point from which a cloud is baked: the middle of where eyes can be if all of them are on this side of the
     * cloud, otherwise the first camera or the player's start.
     */
    private static Vec3 bakePoint(LoadContext load, PlacedCloud cloud) {
        Level level = load.scene().level();
        BoundingSphere eyes = load.drawn().eyes();
        if (eyes != null && eyes.radius() < cloud.source().bounds().nearest(eyes.centre())) {
            return eyes.centre();
        }
        if (!level.cameras().isEmpty()) {
            return level.cameras().get(0).position();
        }
        return level.player() == null ? Vec3.ZERO : level.player().feet().plus(EYE_OVER_FEET);
    }

    @Override
    public void follow(Environment newEnvironment, CloudInterval newNow) {
        environment = newEnvironment;
        now = newNow;
    }

    @Override
    public void prepare(View view) {
        if (now == handled || placed.presence() <= 0) {
            return;
        }
        boolean isJump = handled == null || Math.abs(now.seconds() - handled.seconds()) > JUMP_SECONDS;
        boolean isCut = clouds.cuts() != cuts;
        handled = now;
        cuts = clouds.cuts();
        if (drawn.faces() == null || isJump && change() > 0 || isCut && change() >= 1) {
            baker.begin(drawn, environment, now);
            baker.draw(Integer.MAX_VALUE, view);
            fade = 1;
        } else {
            advance(view);
        }
    }

    private void advance(View view) {
        if (fade < 1) {
            fade = Math.min(1, (now.seconds() - fadeStart) / fadeSeconds);
        } else if (!baker.isDone()) {
            baker.draw(1, view);
            if (baker.isDone()) {
                fadeIn();
            }
        } else if (change() >= 1) {
            baker.begin(other, environment, now);
        }
    }

    private void fadeIn() {
        double passed = Math.abs(other.moment().seconds() - drawn.moment().seconds());
        SkyPicture passing = drawn;
        drawn = other;
        other = passing;
        fadeStart = now.seconds();
        fadeSeconds = Math.max(SHORTEST_FADE_SECONDS, Math.min(LONGEST_FADE_SECONDS, passed));
        fade = 0;
    }

    /** Returns how much of what is drawn has changed; 1 as soon as it should be drawn again. */
    private double change() {
        SkyPicture.Moment then = drawn.moment();
        Vec3 sun = CloudTimeline.towardsSun(environment);
        double turned = Math.atan2(sun.cross(then.towardsSun()).length(), sun.dot(then.towardsSun()));
        return Math.max(
                texelsOff(then) / MOST_TEXELS,
                Math.max(turned / MOST_SUN_RADIANS, Math.abs(placed.presence() - then.presence()) / MOST_PRESENCE));
    }

    /** Returns by how many texels parts of the cloud are elsewhere than drawn: what is as far as its middle follows the wind. */
    private double texelsOff(SkyPicture.Moment then) {
        double blown = placed.drift().minus(then.drift()).length();
        double evolved = evolutionSpeed * Math.abs(now.seconds() - then.seconds());
        double parallax = Math.abs(1 / then.nearestMetres() - 1 / then.middleMetres());
        return baker.focalTexels() * (blown * parallax + evolved / then.nearestMetres());
    }

    @Override
    public void draw(CloudCanvas canvas) {
        SkyPicture fading = fade < 1 ? other : drawn;
        drawn.bind(TextureUnit.CLOUD_FACES);
        fading.bind(TextureUnit.CLOUD_FACES_BEFORE);
        SkyUniforms uniforms = programs.use(canvas.pixels());
        canvas.put(uniforms.cloud, placed);
        put(uniforms, 0, drawn);
        put(uniforms, 1, fading);
        uniforms.fade.set(fade);
        uniforms.skyLayer.set(
                baker.isLayer() ? baker.heightOfMiddle() : 0, placed.source().halfCurvature(), baker.height());
        triangle.draw();
    }

    private void put(SkyUniforms uniforms, int at, SkyPicture picture) {
        BakedFaces faces = picture.faces();
        uniforms.skyAxes.get(3 * at).set(faces.axes().right());
        uniforms.skyAxes.get(3 * at + 1).set(faces.axes().up());
        uniforms.skyAxes.get(3 * at + 2).set(faces.axes().back());
        List<Integer> layers = faces.layers();
        uniforms.skyLayers.get(2 * at).set(layers.get(0), layers.get(2), layers.get(4));
        uniforms.skyLayers.get(2 * at + 1).set(layers.get(1), layers.get(3), layers.get(5));
        uniforms.skyHalf.get(at).set(faces.halfWidth(), faces.halfHeight());
        Vec3 drifted = placed.drift().minus(picture.moment().drift());
        uniforms.skyWind.get(at).set(drifted, picture.distanceOfShift());
    }
}
