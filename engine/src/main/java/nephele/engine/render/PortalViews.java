package nephele.engine.render;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.render.RenderSettings.Deepest;
import nephele.engine.render.RenderSettings.Narrowing;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameEnvironment;
import nephele.engine.render.frame.NestedViews;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.RenderResources;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.resource.OpeningMesh;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.PixelRectangle;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewNode;
import nephele.engine.scene.ViewTree;
import nephele.engine.scene.VisibleSet;

/** Draws the views through openings, for levels that may have some. */
final class PortalViews implements NestedViews, AutoCloseable {
    private final GlContext gl;
    private final RenderSettings settings;
    private final RenderResources resources;
    private final Scene scene;
    private final FramePasses passes;
    private final List<Pass> skies;
    private final ViewCopies copies;
    /** Copies for views with pictures of their own, which may have another size. */
    private final ViewCopies pictureCopies;

    private final FrameEnvironment environment;
    private final OpeningMesh openings;
    private final PortalPictures pictures;
    private final PreviousPicture previous;
    private final Multisampling multisampling;
    /** By depth: a view is drawn completely after the views that are visible in it. */
    private final List<VisibleSet> visible = new ArrayList<>();

    private final List<FrameContext> contexts = new ArrayList<>();
    private ViewTree tree;
    private RenderTarget frameBuffer;

    /** @param copies copies for views that are drawn into the same target as the main one */
    PortalViews(
            GlContext gl,
            RenderSettings settings,
            RenderResources resources,
            Scene scene,
            FramePasses passes,
            ViewCopies copies) {
        this.gl = gl;
        this.settings = settings;
        this.resources = resources;
        this.scene = scene;
        this.passes = passes;
        this.copies = copies;
        pictureCopies = copies.another();
        skies = passes.skies();
        openings = resources.get(OpeningMesh.RESOURCE);
        environment = resources.environment();
        pictures = new PortalPictures(
                gl, technique().copies() ? 1 : settings.quality().portalResolution());
        previous = new PreviousPicture(gl, scene.mirrors());
        multisampling = new Multisampling(gl, settings.quality().samples(), false);
    }

    /** Chooses the views of a frame. */
    ViewNode choose(View main, FrameState frameState, RenderTarget picture) {
        tree = previous.nextTree();
        tree.build(
                main,
                frameState,
                picture.width(),
                picture.height(),
                settings.quality().viewBudget());
        previous.match(tree, picture.width(), picture.height());
        openings.upload(tree, previous.history());
        return tree.root();
    }

    /**
     * Draws the views with pictures of their own, after everything that all views share.
     *
     * @param drawn the frame buffer; its content is overwritten
     */
    void drawPictures(FrameState frameState, RenderTarget picture, RenderTarget drawn) {
        if (technique().hasPictures()) {
            frameBuffer = drawn;
            pictures.begin(drawn.format(), picture.width(), picture.height());
            drawPictures(tree.root(), frameState, picture);
            enter(tree.root());
        }
    }

    /** Returns the view before, on this side of a portal that the eye has passed through since; see {@link ViewTree#followed}. */
    View followed(View before) {
        return tree.followed(before);
    }

    private PortalTechnique technique() {
        return settings.quality().portalTechnique();
    }

    /** Keeps the finished frame as history, before anything is drawn over it. */
    void end(RenderTarget surface) {
        int drawn = tree.views().size() - 1;
        boolean mayEndSoon = drawn > 0 && 2 * (drawn + 1) > settings.quality().viewBudget();
        if (settings.deepest() == Deepest.HISTORY
                && (mayEndSoon || !tree.terminals().isEmpty())) {
            previous.remember(tree, surface);
        } else {
            previous.forget();
        }
    }

    /** Returns the number of views drawn, without the main one. */
    int drawn() {
        return tree == null ? 0 : tree.views().size() - 1;
    }

    void forget() {
        previous.forget();
    }

    @Override
    public Filling filling(ViewNode child) {
        if (!child.isTerminal()) {
            return technique().hasPictures() ? Filling.PICTURE : Filling.VIEW;
        }
        if (settings.deepest() == Deepest.MARK) {
            return Filling.MARK;
        }
        return previous.history().of(child) == null ? Filling.SKY : Filling.PICTURE;
    }

    @Override
    public Texture picture(ViewNode child) {
        return child.isTerminal() ? previous.picture() : pictures.of(child).colour();
    }

    @Override
    public void draw(FrameContext frame, ViewNode child) {
        enter(child);
        drawPasses(child, frame.frameState(), frame.surface(), copies);
        enter(frame.node());
    }

    @Override
    public void drawSky(FrameContext frame, ViewNode child) {
        resources.setView(child.view());
        FrameContext context = context(child.depth());
        context.begin(frame.frameState(), frame.surface());
        context.setView(child.view(), child, null, null);
        for (int i = 0; i < skies.size(); i++) {
            skies.get(i).draw(context);
        }
        resources.setView(frame.view());
    }

    @Override
    public int openingsCounted(ViewNode node) {
        return technique().hasPictures() ? 0 : node.depth();
    }

    private void enter(ViewNode node) {
        resources.setView(node.view());
        if (node.parent() == null || settings.narrowing() == Narrowing.OFF) {
            gl.state().noScissor();
        } else {
            scissor(node.pixels(), 1, 1);
        }
    }

    /** Draws the deepest views first, so that a view's nested pictures exist before it is drawn. */
    private void drawPictures(ViewNode node, FrameState frameState, RenderTarget picture) {
        for (int i = 0; i < node.children().size(); i++) {
            ViewNode child = node.children().get(i);
            if (!child.isTerminal()) {
                drawPictures(child, frameState, picture);
                drawPicture(child, frameState, picture);
            }
        }
    }

    private void drawPicture(ViewNode node, FrameState frameState, RenderTarget picture) {
        RenderTarget own = pictures.take(node);
        RenderTarget target = technique().copies() ? frameBuffer : multisampling.inPlaceOf(own, own.format());
        resources.setView(node.view());
        if (settings.narrowing() == Narrowing.OFF) {
            gl.state().noScissor();
        } else {
            scissor(
                    node.pixels(),
                    target.width() / (double) picture.width(),
                    target.height() / (double) picture.height());
        }
        Vec3 behind = environment.clearColour(node.view());
        target.clearWithinScissor(
                behind.x(), behind.y(), behind.z(), resources.request().skyAlpha());
        drawPasses(node, frameState, target, pictureCopies);
        copy(target, own);
        gl.state().noScissor();
        for (int i = 0; i < node.children().size(); i++) {
            if (!node.children().get(i).isTerminal()) {
                pictures.release(node.children().get(i));
            }
        }
    }

    /**
     * Copies a view that was not drawn directly into its own picture; the scissor limits the copied pixels except with
     * {@link PortalTechnique#COPY}.
     */
    private void copy(RenderTarget drawn, RenderTarget own) {
        if (technique() == PortalTechnique.COPY) {
            gl.state().noScissor();
        }
        if (drawn != own) {
            drawn.copyTo(own);
        }
    }

    /**
     * Sets the scissor to the pixels of a target of another size, and to one more on each side if it is smaller, or if the
     * picture may be shifted.
     */
    private void scissor(PixelRectangle pixels, double acrossScale, double upScale) {
        int margin = acrossScale < 1 || resources.request().isAccumulated() ? 1 : 0;
        int x = (int) Math.floor(pixels.x() * acrossScale) - margin;
        int y = (int) Math.floor(pixels.y() * upScale) - margin;
        int right = (int) Math.ceil((pixels.x() + pixels.width()) * acrossScale) + margin;
        int top = (int) Math.ceil((pixels.y() + pixels.height()) * upScale) + margin;
        gl.state().scissor(Math.max(x, 0), Math.max(y, 0), right - Math.max(x, 0), top - Math.max(y, 0));
    }

    private void drawPasses(ViewNode node, FrameState frameState, RenderTarget surface, ViewCopies viewCopies) {
        VisibleSet solids = scene.solids().isEmpty() ? null : visible(node);
        FrameContext context = context(node.depth());
        context.begin(frameState, surface);
        context.setView(node.view(), node, solids, settings.limits(node));
        passes.drawView(context, viewCopies);
    }

    private FrameContext context(int depth) {
        while (contexts.size() <= depth) {
            contexts.add(new FrameContext(this));
        }
        return contexts.get(depth);
    }

    private VisibleSet visible(ViewNode node) {
        while (visible.size() <= node.depth()) {
            visible.add(new VisibleSet(scene.solids()));
        }
        VisibleSet set = visible.get(node.depth());
        if (settings.narrowing() == Narrowing.ON) {
            settings.culling().find(set, node.frustum());
        } else {
            settings.culling().find(set, node.view());
        }
        return set;
    }

    @Override
    public void close() {
        pictures.close();
        previous.close();
        multisampling.close();
        pictureCopies.close();
    }
}
