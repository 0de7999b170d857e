package nephele.engine.render.pass.cloud.shaft;

import java.util.List;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.ShaftClouds;
import nephele.engine.level.Cloud;
import nephele.engine.level.appearance.ShaftLight;
import nephele.engine.level.appearance.SunAndMoon;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.gl.DrawState;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.resource.RendererClouds;
import nephele.engine.render.resource.ShaftTables;
import nephele.engine.scene.View;

/**
 * Finds how much of the air's light clouds take, at low resolution and for several distances, before anything in a view is
 * drawn; everything that is seen through air reads it, see {@code air.glsl}.
 */
public final class ShaftPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("cloud.shafts", Stage.IN_VIEWS, ShaftPass::requiredBy)
            .using(RendererClouds.RESOURCE, ShaftTables.RESOURCE);

    private final GlContext gl;
    private final RendererClouds levelClouds;
    private final ShaftTables tables;
    private final FullScreenTriangle triangle;
    /** {@code null} if the clouds that have shafts have no extinction. */
    private final ShaftClouds clouds;

    private final ShadeTexture shade;
    private final ShaftProgram program;
    private final DrawState.Limits limits = new DrawState.Limits();

    private ShaftPass(LoadContext context) {
        gl = context.gl();
        levelClouds = context.get(RendererClouds.RESOURCE);
        tables = context.get(ShaftTables.RESOURCE);
        clouds = levelClouds.current().shafts();
        triangle = context.own(new FullScreenTriangle(gl, "shafts"));
        shade = clouds == null ? null : new ShadeTexture(context, clouds.grid());
        program = clouds == null ? null : new ShaftProgram(context);
    }

    private static List<Required> requiredBy(FrameRequest request) {
        var environment = request.level().environment();
        long count =
                WeatherClouds.all(environment).stream().filter(Cloud::shafts).count();
        return ShaftLight.isIn(environment)
                ? List.of(new Required(
                        "environment.clouds: the air shows the shadows of " + count + " with shafts", ShaftPass::new))
                : List.of();
    }

    @Override
    public void draw(FrameContext frame) {
        if (clouds == null) {
            return;
        }
        View view = frame.view();
        CloudInterval now = levelClouds.current().now();
        shade.show(now);
        gl.state().beginLayer(ShaftTables.DIVISOR, limits);
        tables.target(view, frame.surface()).bind();
        gl.state().set(Depth.OFF, Blend.REPLACE, Cull.NONE);
        ShaftLight light = ShaftLight.of(SunAndMoon.of(frame.frameState().environment()));
        Vec3 eye = view.eye().minus(clouds.drift(now.seconds()));
        Vec3 focus = clouds.foot(levelClouds.current().focus(), now.seconds(), light.towards());
        shade.bind();
        program.use(now, clouds, light, new ShaftProgram.Eye(eye, focus.minus(eye)));
        triangle.draw();
        gl.state().endLayer(limits);
        frame.surface().bind();
        tables.setView(view);
    }
}
