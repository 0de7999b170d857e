package nephele.engine.render.pass.cloud.skybox;

import nephele.engine.render.resource.RendererClouds;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.level.Cloud;
import nephele.engine.level.Environment;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.pass.cloud.CloudCanvas;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.PerPixels;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.scene.View;

/**
 * A cloud of which pictures around one point are shown, moved by the wind as what is as far as its middle. If parts of it
 * are elsewhere by a texel, or its light has changed, since they were drawn, the next ones are drawn, one a frame, and then
 * fade in for as long as that has taken. After a jump in time all are drawn at once.
 */
final class SkyboxCloud implements CloudDrawing {
    /** A longer time between two frames is a jump. */
    private static final double JUMP_SECONDS = 1;

    private static final double SHORTEST_FADE_SECONDS = 0.5;
    private static final double LONGEST_FADE_SECONDS = 10;
    /** Motion from which on pictures are drawn again. */
    private static final double MOST_TEXELS = 1;

    private static final double MOST_SUN_RADIANS = Math.toRadians(2);
    private static final double MOST_PRESENCE = 1.0 / 16;

    private final RendererClouds clouds;
    private final PlacedCloud placed;
    private final SkyBaker baker;
    private final PerPixels<SkyboxProgram> programs;
    private final FullScreenTriangle triangle;
    /** Metres a second by which a shape that evolves counts as moving: a billow in each generation. */
    private final double evolutionSpeed;

    private SkyPicture shown;
    /** The pictures that fade out, or that are drawn next. */
    private SkyPicture other;

    private Environment environment;
    private CloudInterval now;
    private CloudInterval handled;
    private int cuts;
    private double fadeStart;
    private double fadeSeconds;
    private double fade = 1;

    SkyboxCloud(
            LoadContext load,
            PlacedCloud placed,
            SkyBaker baker,
            PerPixels<SkyboxProgram> programs,
            FullScreenTriangle triangle) {
        clouds = load.get(RendererClouds.RESOURCE);
        this.placed = placed;
        this.baker = baker;
        this.programs = programs;
        this.triangle = triangle;
        shown = load.own(new SkyPicture(load.gl()));
        other = load.own(new SkyPicture(load.gl()));
        evolutionSpeed = placed.source().evolves()
                        && placed.source().cloud().density() instanceof Cloud.Density.Noise noise
                ? noise.featureMetres() / placed.source().cloud().motion().evolutionSeconds()
                : 0;
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
        if (shown.faces() == null || isJump && change() > 0 || isCut && change() >= 1) {
            baker.begin(shown, environment, now);
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
        double passed = Math.abs(other.moment().seconds() - shown.moment().seconds());
        SkyPicture passing = shown;
        shown = other;
        other = passing;
        fadeStart = now.seconds();
        fadeSeconds = Math.max(SHORTEST_FADE_SECONDS, Math.min(LONGEST_FADE_SECONDS, passed));
        fade = 0;
    }

    /** Returns how much of what is shown has changed; 1 as soon as it should be drawn again. */
    private double change() {
        SkyPicture.Moment then = shown.moment();
        Vec3 sun = CloudTimeline.towardsSun(environment);
        double turned = Math.atan2(sun.cross(then.towardsSun()).length(), sun.dot(then.towardsSun()));
        return Math.max(
                texelsOff(then) / MOST_TEXELS,
                Math.max(turned / MOST_SUN_RADIANS, Math.abs(placed.presence() - then.presence()) / MOST_PRESENCE));
    }

    /** Returns by how many texels parts of the cloud are elsewhere than shown: what is as far as its middle follows the wind. */
    private double texelsOff(SkyPicture.Moment then) {
        double blown = placed.drift().minus(then.drift()).length();
        double evolved = evolutionSpeed * Math.abs(now.seconds() - then.seconds());
        double parallax = Math.abs(1 / then.nearestMetres() - 1 / then.middleMetres());
        return baker.focalTexels() * (blown * parallax + evolved / then.nearestMetres());
    }

    @Override
    public void draw(CloudCanvas canvas) {
        SkyPicture fading = fade < 1 ? other : shown;
        shown.bind(TextureUnit.CLOUD_FACES);
        fading.bind(TextureUnit.CLOUD_FACES_BEFORE);
        SkyboxProgram program = programs.of(canvas.pixels());
        program.use(canvas, placed, fade);
        program.putLayer(
                baker.isLayer() ? baker.heightOfMiddle() : 0, placed.source().halfCurvature(), baker.height());
        program.putShown(shown, placed.drift());
        program.putBefore(fading, placed.drift());
        triangle.draw();
    }
}
