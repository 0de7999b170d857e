package nephele.engine.rule;

import java.util.Map;
import java.util.function.Consumer;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RayCast;
import nephele.engine.level.Hint;
import nephele.engine.level.Language;
import nephele.engine.level.Place;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.json.WordFormats;
import nephele.engine.level.layout.BrushIndex;
import nephele.engine.level.layout.FacePath;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerDimensions.Stance;

/** Rules for what leads a player: hints that can be read, a par that can be reached, exits and a landmark. */
final class GuidanceRules {
    /** The longest text that the smallest window shows whole. */
    private static final int MOST_LETTERS = 140;

    static final LevelRule HINTS = LevelRule.ofRecords((level, report) -> {
        LevelRule.each("hints", level.hints(), (path, hint) -> text(path + ".text", hint, report));
        if (!level.hints().isEmpty() && level.player() == null) {
            report.accept(Problem.warning("hints", "nobody plays the level: add a player, or delete the hints"));
        }
    });

    static final LevelRule PAR = LevelRule.ofRecords((level, report) -> {
        if (level.par() != null && level.exits().isEmpty()) {
            report.accept(Problem.warning("par", "nothing ends the level: add an exit, or leave the par out"));
        } else if (level.par() != null && level.par().portals() > 0 && level.portalGun() == null) {
            report.accept(Problem.warning("par.portals", "nobody can shoot portals here: add a portalGun, or write 0"));
        }
    });

    /** The height of a standing player's centre above the feet. */
    private static final double CENTRE_METRES = 0.9;

    static final LevelRule EXITS =
            LevelRule.ofRecords((level, report) -> LevelRule.each("exits", level.exits(), (path, exit) -> {
                if (exit.heightMetres() < CENTRE_METRES) {
                    report.accept(Problem.warning(
                            path + ".heightMetres",
                            "a player who stands in the exit has the centre above it, " + CENTRE_METRES
                                    + " m above the feet: make it higher"));
                }
                LevelRule.each("solids", level.solids(), (solidPath, solid) -> {
                    if (ViewpointRules.isStandingIn(solid, exit.feet())) {
                        report.accept(Problem.warning(
                                        path + ".feet",
                                        "the exit's middle is inside " + solidPath + " ('" + solid.id()
                                                + "'): move it out")
                                .about(Topic.ENTITY_IN_SOLID));
                    }
                });
            }));

    /** Distance before a point of the sphere from which nothing hides it: it may be on a surface. */
    private static final double TOUCHING_METRES = 0.01;

    /** A player who has just begun sees the landmark by looking around; portals and mirrors are left out. */
    static final LevelRule LANDMARK = new LevelRule(LevelRule.Stage.WORLD, (level, assets, statics, report) -> {
        if (level.landmark() == null || level.player() == null) {
            return;
        }
        Place landmark = level.landmark();
        Vec3 eye = level.player().feet().plus(new Vec3(0, Stance.STANDING.eyeMetres(), 0));
        if (landmark.contains(eye) || isVisible(eye, landmark, CollisionWorld.of(statics))) {
            return;
        }
        int around = new BrushIndex(statics).holding(landmark.position(), 0);
        if (around >= 0) {
            report.accept(Problem.warning(
                            "landmark.position",
                            "the landmark is inside "
                                    + (around < level.solids().size() ? FacePath.named(level, around) : "a model")
                                    + ", and its sphere is hidden from the"
                                    + " player's start: move it out, or raise radiusMetres")
                    .about(Topic.ENTITY_IN_SOLID));
        } else {
            report.accept(Problem.warning(
                    "landmark.position",
                    "the landmark cannot be seen from the player's start: move it to where nothing hides it, or raise"
                            + " radiusMetres"));
        }
    });

    private GuidanceRules() {}

    private static void text(String path, Hint hint, Consumer<Problem> report) {
        String english = hint.text().get(Language.EN);
        if (english == null || english.isBlank()) {
            report.accept(Problem.error(
                    path, "has no English text, which stands for every language that is missing: add en"));
        }
        for (Map.Entry<Language, String> authored : hint.text().entrySet()) {
            int letters =
                    authored.getValue().codePointCount(0, authored.getValue().length());
            if (letters > MOST_LETTERS) {
                report.accept(Problem.warning(
                        path + "." + WordFormats.Choice.word(authored.getKey()),
                        letters + " letters are too long for a small window: use at most " + MOST_LETTERS));
            }
        }
    }

    /** Looks at the sphere's centre and at 26 points of its surface. */
    private static boolean isVisible(Vec3 eye, Place landmark, CollisionWorld world) {
        RayCast cast = new RayCast();
        for (int i = 0; i < 27; i++) {
            Vec3 path = new Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            double unit = path.length() == 0 ? 0 : landmark.radiusMetres() / path.length();
            Vec3 towards = landmark.position().addScaled(unit, path).minus(eye);
            double metres = towards.length();
            double limit = metres - TOUCHING_METRES;
            if (limit <= 0 || !cast.cast(world, Ray.of(eye, towards.scaled(1 / metres)), limit)) {
                return true;
            }
        }
        return false;
    }
}
