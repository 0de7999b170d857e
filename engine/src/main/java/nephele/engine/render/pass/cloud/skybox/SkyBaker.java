package nephele.engine.render.pass.cloud.skybox;

import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.level.Environment;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.RenderResources;
import nephele.engine.render.gl.DrawState;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.pass.cloud.CloudCanvas;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.render.resource.RendererClouds;
import nephele.engine.scene.View;

/** Draws the pictures of a cloud from one point, each when it is told to; all show the time at which it began. */
final class SkyBaker {
    private static final double NEAREST_METRES = 1;

    private final GlContext gl;
    private final RenderResources resources;
    private final RendererClouds clouds;
    private final PlacedCloud still;
    private final CloudDrawing drawing;
    private final Vec3 bakePoint;
    private final int texelsOfFace;
    private final DrawState.Limits limits = new DrawState.Limits();
    private SkyPicture picture;
    private Vec3 focus;
    private int drawn;

    /** @param still the cloud at the time that is baked, which {@code drawing} draws */
    SkyBaker(LoadContext load, PlacedCloud still, CloudDrawing drawing, Vec3 bakePoint) {
        gl = load.gl();
        resources = load.resources();
        clouds = load.get(RendererClouds.RESOURCE);
        this.still = still;
        this.drawing = drawing;
        this.bakePoint = bakePoint;
        texelsOfFace = load.quality().cloudSkyboxTexels();
    }

    /** Begins the pictures of a time. */
    void begin(SkyPicture begun, Environment environment, CloudInterval now) {
        still.follow(now);
        drawing.follow(environment, now);
        focus = clouds.current().focus();
        picture = begun;
        drawn = 0;
        picture.begin(BakedFaces.of(bakePoint, still.bounds(), texelsOfFace), moment(environment, now.seconds()));
    }

    private SkyPicture.Moment moment(Environment environment, double seconds) {
        return new SkyPicture.Moment(
                seconds,
                still.drift(),
                Math.max(NEAREST_METRES, still.distance(bakePoint)),
                Math.max(NEAREST_METRES, middleMetres()),
                isLayer(),
                still.presence(),
                CloudTimeline.towardsSun(environment));
    }

    private double middleMetres() {
        return isLayer()
                ? Math.abs(heightOfMiddle())
                : still.bounds().centre().minus(bakePoint).length();
    }

    /** Returns true if the cloud is endless. */
    boolean isLayer() {
        return still.bounds().maxX() == Double.POSITIVE_INFINITY;
    }

    /** Returns the height of the cloud's middle over the bake point. */
    double heightOfMiddle() {
        return (still.bounds().minY() + still.bounds().maxY()) / 2 - bakePoint.y();
    }

    /** Returns the height of the bake point over a round planet. */
    double height() {
        return bakePoint.y();
    }

    /** Returns the texels of a face for something that is as wide as far. */
    double focalTexels() {
        return texelsOfFace / 2.0;
    }

    /** Returns true if all pictures are drawn, or none was begun. */
    boolean isDone() {
        return picture == null || drawn == picture.faces().count();
    }

    /** Draws some of the pictures that are left; the view of the following draws is {@code view} as before. */
    void draw(int most, View view) {
        gl.state().beginLayer(1, limits);
        for (int i = 0; i < most && !isDone(); i++) {
            View face = picture.faces().view(drawn);
            resources.uniforms().upload(face, 1);
            picture.target(drawn).clearTransparent();
            gl.state().set(Depth.OFF, Blend.REPLACE, Cull.NONE);
            drawing.draw(CloudCanvas.baked(face, focus));
            drawn++;
        }
        gl.state().endLayer(limits);
        resources.resume(view);
    }
}
