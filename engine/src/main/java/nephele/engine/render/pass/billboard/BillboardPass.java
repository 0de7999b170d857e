package nephele.engine.render.pass.billboard;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import nephele.engine.level.Billboards;
import nephele.engine.particle.BackToFront;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.SurfaceLight;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.resource.BillboardList;
import nephele.engine.render.resource.BillboardQuads;
import nephele.engine.render.resource.BillboardQuads.Cluster;
import nephele.engine.render.resource.BillboardSource.Kind;
import nephele.engine.scene.View;

/**
 * Draws billboards in each view, turned to its eye or to the level's observer. Those with edges are drawn by clusters, in the order of
 * their places; blended ones each for itself, the farthest first, equal distances in the order of the level.
 */
public final class BillboardPass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("billboard", Stage.IN_VIEWS, request -> requiredBy(request, Kind.WITH_EDGES));

    public static final RenderFeature BLENDED = new RenderFeature(
            "billboard.blended", Stage.IN_VIEWS_AFTER_OPAQUE, request -> requiredBy(request, Kind.BLENDED));

    private final GlContext gl;
    private final Kind kind;
    private final Blend blend;
    private final TargetReads reads;
    private final SurfaceLight light;
    private final BillboardQuads quads;
    private final BillboardProgram program;
    private final BillboardList list;
    private final List<Cluster> seen = new ArrayList<>();
    private final BackToFront order = new BackToFront();

    private BillboardPass(LoadContext context, Kind kind, TargetReads reads) {
        this.kind = kind;
        this.reads = reads;
        gl = context.gl();
        light = context.shared().surfaceLight();
        boolean isSampled = context.quality().samples() > 1;
        blend = kind == Kind.BLENDED
                ? Blend.PREMULTIPLIED_OVER
                : isSampled ? Blend.REPLACE_COVERED_SAMPLES : Blend.REPLACE;
        quads = context.billboards(kind);
        program = new BillboardProgram(context, kind);
        list = context.own(new BillboardList(gl));
    }

    private static List<Required> requiredBy(FrameRequest request, Kind kind) {
        List<Billboards> all = request.level().billboards();
        int[] found = IntStream.range(0, all.size())
                .filter(i -> all.get(i).blended() == (kind == Kind.BLENDED))
                .toArray();
        if (found.length == 0) {
            return List.of();
        }
        TargetReads light = request.lightMaps().dynamicObjects();
        TargetReads reads = kind == Kind.BLENDED && request.fadesAtSurfaces() ? light.and(Target.VIEW_DEPTH) : light;
        String because = "billboards[" + found[0] + "]: "
                + (kind == Kind.BLENDED ? "blended with what is behind them" : "pictures with edges");
        return List.of(new Required(because, context -> new BillboardPass(context, kind, reads)));
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public boolean needsCopies(FrameContext frame) {
        quads.findSeen(frame.seen(), seen);
        return kind == Kind.BLENDED && !seen.isEmpty();
    }

    @Override
    public void draw(FrameContext frame) {
        quads.findSeen(frame.seen(), seen);
        if (seen.isEmpty()) {
            return;
        }
        quads.follow(frame.frameState().seconds());
        frame.surface().bind();
        Depth depth = kind == Kind.BLENDED ? Depth.LESS_OR_EQUAL : Depth.LESS_AND_WRITE;
        gl.state().set(depth, blend, Cull.NONE, frame.clipDistances());
        light.bind(reads);
        program.use(frame.view(), frame.frameState().observer());
        quads.bind();
        if (kind == Kind.BLENDED) {
            drawSorted(frame.view());
        } else {
            list.draw(seen, quads);
        }
    }

    private void drawSorted(View view) {
        float eyeX = (float) (view.eyeX() - light.anchor().x());
        float eyeY = (float) (view.eyeY() - light.anchor().y());
        float eyeZ = (float) (view.eyeZ() - light.anchor().z());
        order.begin(quads.count());
        for (Cluster cluster : seen) {
            for (int image = cluster.first(); image < cluster.end(); image++) {
                float x = quads.middle(image, 0) - eyeX;
                float y = quads.middle(image, 1) - eyeY;
                float z = quads.middle(image, 2) - eyeZ;
                order.add(image, x * x + y * y + z * z);
            }
        }
        order.sort();
        int array = quads.array(order.at(0));
        list.begin();
        for (int i = 0; i < order.count(); i++) {
            int image = order.at(i);
            if (quads.array(image) != array) {
                draw(array);
                array = quads.array(image);
                list.begin();
            }
            list.add(image);
        }
        draw(array);
    }

    private void draw(int array) {
        quads.bindSprites(array);
        list.draw();
    }
}
