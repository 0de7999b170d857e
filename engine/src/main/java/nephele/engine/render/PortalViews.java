package nephele.engine.render;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.RenderSettings.Narrowing;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.NestedViews;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.SharedResources;
import nephele.engine.render.gl.DrawState;
import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.Moment;
import nephele.engine.scene.PixelRectangle;
import nephele.engine.scene.SolidGeometry;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewNode;
import nephele.engine.scene.ViewTree;
import nephele.engine.scene.VisibleSet;

/** The views through portals of a level that may have some. */
final class PortalViews implements NestedViews {
    private final GlContext gl;
    private final RenderSettings settings;
    private final SharedResources shared;
    private final SolidGeometry solids;
    private final List<Pass> passes;
    private final double exposure;
    private final ViewTree tree = new ViewTree();
    /** By depth: a view is drawn to its end after those that are seen in it. */
    private final List<VisibleSet> visible = new ArrayList<>();

    /** @param passes of every view, in frame order */
    PortalViews(
            GlContext gl,
            RenderSettings settings,
            SharedResources shared,
            SolidGeometry solids,
            List<Pass> passes,
            double exposure) {
        this.gl = gl;
        this.settings = settings;
        this.shared = shared;
        this.solids = solids;
        this.passes = passes;
        this.exposure = exposure;
    }

    /** Chooses the views of a frame. */
    ViewNode begin(View main, Moment moment, int width, int height) {
        tree.grow(main, moment, width, height, settings.quality().viewBudget());
        shared.openings().upload(tree);
        gl.state().stencil(DrawState.Stencil.OFF, 0);
        gl.state().depthOf(DrawState.DepthOf.SURFACE);
        return tree.root();
    }

    @Override
    public boolean fills(ViewNode child) {
        return !child.isTerminal();
    }

    @Override
    public void draw(FrameContext frame, ViewNode child) {
        VisibleSet seen = solids.isEmpty() ? null : see(child);
        enter(child);
        FrameContext context =
                new FrameContext(child.view(), frame.moment(), frame.surface(), frame.picture(), seen, child, this);
        for (int i = 0; i < passes.size(); i++) {
            passes.get(i).draw(context);
        }
        enter(frame.node());
    }

    private void enter(ViewNode node) {
        shared.frameUniforms().upload(node.view(), exposure);
        if (node.parent() == null || settings.narrowing() == Narrowing.OFF) {
            gl.state().noScissor();
        } else {
            PixelRectangle pixels = node.pixels();
            gl.state().scissor(pixels.x(), pixels.y(), pixels.width(), pixels.height());
        }
    }

    private VisibleSet see(ViewNode node) {
        while (visible.size() <= node.depth()) {
            visible.add(new VisibleSet(solids));
        }
        VisibleSet set = visible.get(node.depth());
        if (settings.narrowing() == Narrowing.ON) {
            settings.culling().find(set, node.frustum());
        } else {
            settings.culling().find(set, node.view());
        }
        return set;
    }
}
