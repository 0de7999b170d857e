package nephele.engine.render.pass.cloud.shaft;

import java.nio.ByteBuffer;
import java.util.List;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.LayerGrid;
import nephele.engine.cloud.cells.SlantedShade;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.ShaftClouds;
import nephele.engine.level.Cloud;
import nephele.engine.level.appearance.ShaftLight;
import nephele.engine.level.appearance.SunAndMoon;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
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
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.pass.cloud.CloudUniforms;
import nephele.engine.render.resource.RendererClouds;
import nephele.engine.render.resource.ShaftTables;
import nephele.engine.scene.View;
import org.lwjgl.system.MemoryUtil;

/**
 * Finds how much of the air's light clouds take, at low resolution and for several distances, before anything in a view is
 * drawn; everything that is seen through air reads it, see {@code air.glsl}.
 */
public final class ShaftPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("cloud.shafts", Stage.IN_VIEWS, ShaftPass::requiredBy)
            .using(RendererClouds.RESOURCE, ShaftTables.RESOURCE);

    private static final String FOLDER = "/nephele/engine/render/pass/cloud/shaft/";

    private final GlContext gl;
    private final RendererClouds levelClouds;
    private final ShaftTables tables;
    private final FullScreenTriangle triangle;
    /** {@code null} if the clouds that have shafts have no extinction. */
    private final ShaftClouds clouds;

    /** The shade at two sampled times, the boxes on top of each other; {@code null} without clouds, as the program. */
    private final Texture shade;

    private final GlProgram<Places> program;
    private SlantedShade shadeFrom;
    private SlantedShade shadeTo;
    private final DrawState.Limits limits = new DrawState.Limits();

    private record Places(CloudUniforms.Boxes boxes, Uniforms.Vector3 slant, Uniforms.Vector2 planet) {}

    private ShaftPass(LoadContext context) {
        gl = context.gl();
        levelClouds = context.get(RendererClouds.RESOURCE);
        tables = context.get(ShaftTables.RESOURCE);
        clouds = levelClouds.current().shafts();
        triangle = context.own(new FullScreenTriangle(gl, "shafts"));
        shade = clouds == null ? null : texture(context, clouds.grid());
        program = clouds == null ? null : program(context);
    }

    private static Texture texture(LoadContext context, LayerGrid grid) {
        CellBox cells = grid.box(0, new LayerGrid.Column(0, 0));
        return context.own(new Texture(
                context.gl(),
                "shade of clouds",
                Texture.Shape.VOLUME,
                PixelFormat.RG16,
                new Texture.Extent(cells.nx(), cells.ny() * grid.levels(), cells.nz()),
                Sampling.LINEAR_CLAMP));
    }

    private static GlProgram<Places> program(LoadContext context) {
        var defines = Defines.of(context).with("MOST_BOXES", ShaftClouds.LEVELS).values();
        return GlProgram.of(context.gl(), FOLDER + "shaft.vert", FOLDER + "shaft.frag", defines, Places.class);
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
        upload(now);
        gl.state().beginLayer(ShaftTables.DIVISOR, limits);
        tables.target(view, frame.surface()).bind();
        gl.state().set(Depth.OFF, Blend.REPLACE, Cull.NONE);
        ShaftLight light = ShaftLight.of(SunAndMoon.of(frame.frameState().environment()));
        Vec3 eye = view.eye().minus(clouds.drift(now.seconds()));
        Vec3 focus = clouds.foot(levelClouds.current().focus(), now.seconds(), light.towards());
        shade.bind(TextureUnit.SHAFT_SHADE);
        program.use();
        put(program.uniforms(), now, light, eye, focus.minus(eye));
        triangle.draw();
        gl.state().endLayer(limits);
        frame.surface().bind();
        tables.setView(view);
    }

    /** Uploads the shade of the two times if one of them has changed. */
    private void upload(CloudInterval now) {
        SlantedShade from = now.from().shade();
        SlantedShade to = now.to().shade();
        if (from == shadeFrom && to == shadeTo) {
            return;
        }
        shadeFrom = from;
        shadeTo = to;
        CellBox cells = from.boxes().get(0);
        ByteBuffer texels = MemoryUtil.memAlloc(2 * Short.BYTES * cells.nx() * cells.ny());
        for (int level = 0; level < from.boxes().size(); level++) {
            var rows = new Texture.Region(0, level * cells.ny(), cells.nx(), cells.ny());
            for (int k = 0; k < cells.nz(); k++) {
                from.put(to, level, k, texels.clear().asShortBuffer());
                shade.upload(k, rows, texels.clear());
            }
        }
        MemoryUtil.memFree(texels);
    }

    /**
     * Sets the uniforms.
     *
     * @param eye in the space of the shade
     * @param focus of the boxes, relative to the eye
     */
    private void put(Places places, CloudInterval now, ShaftLight light, Vec3 eye, Vec3 focus) {
        List<CellBox> boxes = now.from().shade().boxes();
        for (int level = 0; level < boxes.size(); level++) {
            places.boxes.put(level, boxes.get(level).box(), eye);
        }
        CellBox narrowest = boxes.get(0);
        places.boxes.cells().set(narrowest.ny(), 0, boxes.size(), now.fraction());
        double reach = clouds.grid().reach() * narrowest.sizeX();
        places.boxes.put(narrowest.box(), eye, focus, reach, reach);
        Vec3 slant = SlantedShade.slant(light.towards());
        places.slant.set(slant.x(), slant.z(), light.strength());
        places.planet.set(clouds.halfCurvature(), eye.y());
    }
}
