package nephele.workshop.prove.picture;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import nephele.engine.measure.ColourVision;
import nephele.engine.render.Capture;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.CharacterPresence;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.host.draw.QualityChoice;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.host.playthrough.Playthrough;
import nephele.host.playthrough.ReplayInput;
import nephele.workshop.prove.picture.LevelSigns.Sign;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Looks at the exits and portals of every level, from 20 m or as far as there is room, with the cameras of both persons,
 * in pixels as large as those of a picture of 1280 × 720 with the usual field of view.
 */
public final class StandingOutProof implements Proof {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 180;
    /** The middle 4 × 4th of a picture of 1280 × 720. */
    private static final double TAN_HALF_HEIGHT = 0.25 * 9 / 16;

    private static final double PIXELS_PER_UNIT = HEIGHT / 2.0 / TAN_HALF_HEIGHT;
    private static final double AROUND_PIXELS = PIXELS_PER_UNIT * Math.tan(Math.toRadians(2));
    private static final double LEAST_CONTRAST = 20;
    private static final int SIGHTS_OF_LEVEL = 6;
    private static final int TICKS = 60;
    private static final double MOST_MOVED_METRES = 0.5;
    /** The glow around a sign, and its way on the picture of the camera behind the player. */
    private static final double BESIDE_METRES = 0.3;

    private final List<String> files;
    private final Path pictures;

    /** Uses the levels of the checkout in the working directory. */
    public StandingOutProof() {
        this(
                List.of(
                        "levels/01-courtyard.json",
                        "levels/02-first-shot.json",
                        "levels/03-momentum.json",
                        "levels/04-cube.json",
                        "levels/05-above-the-clouds.json",
                        "levels/06-standing-stones.json",
                        "levels/samples/exits.json"),
                null);
    }

    /**
     * @param files levels by path
     * @param pictures a folder for what is seen; {@code null} for none
     */
    public StandingOutProof(List<String> files, Path pictures) {
        this.files = files;
        this.pictures = pictures;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "standing-out",
                "Every exit, every portal and every shot's rim, seen from 20 m or as far as there is room by the"
                        + " cameras of both persons, differs over a quarter of its pixels by 20 of L* or more from the"
                        + " median of the two degrees around it, for normal colour vision and in simulated protanopia,"
                        + " deuteranopia and tritanopia (Machado et al. 2009).",
                "sights",
                (long) files.size() * SIGHTS_OF_LEVEL,
                SIGHTS_OF_LEVEL);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws Exception {
        ProofResult result = signs(0, 0, 0);
        try (var gl = GlContext.offscreen();
                var picture = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, WIDTH, HEIGHT)) {
            for (long unit = from; unit < from + count; ) {
                int file = (int) (unit / SIGHTS_OF_LEVEL);
                long end = Math.min(from + count, (file + 1L) * SIGHTS_OF_LEVEL);
                int first = (int) (unit % SIGHTS_OF_LEVEL);
                result = result.and(look(files.get(file), first, first + (int) (end - unit), gl, picture));
                unit = end;
                progress.unitsDone(unit - from);
            }
        }
        return result.and(new ProofResult(count, 0, List.of(), List.of()));
    }

    private ProofResult look(String file, int first, int end, GlContext gl, RenderTarget picture) throws Exception {
        ProofResult result = ProofResult.NOTHING;
        OpenedLevel opened = new LevelName(file).open();
        var sky = LevelLight.of(opened.placed(), done -> {});
        var scene = Scene.of(opened.placed(), sky);
        var settings = RenderSettings.of(QualityChoice.defaultOutput(opened.level()), Quality.MEDIUM)
                .with(CharacterPresence.POSSIBLE);
        LevelSigns signs = new LevelSigns(opened.placed());
        var bare = Scene.of(opened.placed().edited(opened.level().withExits(List.of())), sky);
        try (var with = LevelRenderer.load(gl, scene, settings);
                var without = LevelRenderer.load(gl, bare, settings.with(Decoration.OFF))) {
            var drawn = new Drawing(file, opened, signs, with, without, picture);
            for (Sign sign : signs.signs()) {
                List<PlayerStart> viewers = signs.viewers(sign);
                for (int i = first; i < Math.min(end, viewers.size()); i++) {
                    result = result.and(drawn.look(sign, viewers.get(i), i, false))
                            .and(drawn.look(sign, viewers.get(i), i, true));
                }
            }
        }
        return result;
    }

    /** A level that is looked at, with and without its signs. */
    private final class Drawing {
        private final String file;
        private final OpenedLevel opened;
        private final LevelSigns signs;
        private final Renderer with;
        private final Renderer without;
        private final RenderTarget picture;
        private final SimLevel world;
        private final SignContrast contrast = new SignContrast(WIDTH, HEIGHT, AROUND_PIXELS);

        Drawing(
                String file,
                OpenedLevel opened,
                LevelSigns signs,
                Renderer with,
                Renderer without,
                RenderTarget picture) {
            this.file = file;
            this.opened = opened;
            this.signs = signs;
            this.with = with;
            this.without = without;
            this.picture = picture;
            world = SimLevel.of(opened.placed());
        }

        ProofResult look(Sign sign, PlayerStart viewer, int number, boolean fromBehind) throws Exception {
            var beginning = new Playthrough.Beginning("seen.json", SimSettings.DEFAULT, viewer);
            var walk = new Playthrough(
                    opened.level(), world, beginning, new ReplayInput(Replay.standing("seen.json", TICKS)));
            walk.verticalFovDegrees(2 * Math.toDegrees(Math.atan(TAN_HALF_HEIGHT)));
            if (fromBehind) {
                walk.changePerson();
            }
            for (int i = 0; i < TICKS; i++) {
                walk.tick();
            }
            Vec3 moved = walk.state().player().feet().minus(viewer.feet());
            if (moved.length() > MOST_MOVED_METRES) {
                return ProofResult.NOTHING; // nobody can stand there
            }
            View view = walk.view((double) WIDTH / HEIGHT);
            FrameState state = walk.frameState();
            shoot(state);
            Vec3 towards = sign.centre().minus(view.eye());
            double depth = -view.alongBack(towards.x(), towards.y(), towards.z());
            double scale = PIXELS_PER_UNIT / depth;
            BufferedImage drawn = draw(with, view, state);
            double[] contrasts = contrast.of(
                    drawn,
                    draw(without, view, state),
                    WIDTH / 2.0 + view.alongRight(towards.x(), towards.y(), towards.z()) * scale,
                    HEIGHT / 2.0 - view.alongUp(towards.x(), towards.y(), towards.z()) * scale,
                    (sign.halfMetres() + BESIDE_METRES) * scale);
            String what = String.format(
                    Locale.ROOT,
                    "%s, %s, sight %d, %s person",
                    file,
                    sign.name(),
                    number,
                    fromBehind ? "third" : "first");
            if (pictures != null) {
                Files.createDirectories(pictures);
                Capture.png(drawn, pictures.resolve(what.replaceAll("[^A-Za-z0-9]+", "-") + ".png"));
            }
            return judged(what, towards.length(), contrasts);
        }

        private void shoot(FrameState state) {
            state.portals(signs.portals());
            for (int i = signs.firstShot(); i < state.portals().size(); i++) {
                state.setPortalLook(i, i - signs.firstShot(), 1);
            }
        }

        private BufferedImage draw(Renderer renderer, View view, FrameState state) {
            renderer.forget();
            renderer.draw(view, state, picture);
            return Capture.image(picture);
        }
    }

    /** @param contrasts by the ordinal of the {@link ColourVision}; {@code null} if most of the sign is hidden */
    private static ProofResult judged(String what, double metres, double[] contrasts) {
        if (contrasts == null) {
            return signs(0, 0, 1);
        }
        List<String> failures = new ArrayList<>();
        List<Figure> figures = new ArrayList<>();
        ColourVision worst = ColourVision.NORMAL;
        for (ColourVision vision : ColourVision.values()) {
            double contrast = contrasts[vision.ordinal()];
            worst = contrast < contrasts[worst.ordinal()] ? vision : worst;
            figures.add(Figure.least("least contrast, " + word(vision), contrast, "of L* (" + what + ")"));
        }
        if (contrasts[worst.ordinal()] < LEAST_CONTRAST) {
            failures.add(String.format(
                    Locale.ROOT, "%s, %.1f m: %.1f of L* (%s)", what, metres, contrasts[worst.ordinal()], word(worst)));
        }
        return signs(1, metres > 18 ? 1 : 0, 0).and(ProofResult.of(0, failures, figures));
    }

    private static ProofResult signs(int visible, int far, int hidden) {
        return ProofResult.of(
                0,
                List.of(),
                Figure.sum("signs seen", visible, ""),
                Figure.sum("of them from 18 m or more", far, ""),
                Figure.sum("signs hidden", hidden, ""));
    }

    private static String word(ColourVision vision) {
        return vision.name().toLowerCase(Locale.ROOT);
    }
}
