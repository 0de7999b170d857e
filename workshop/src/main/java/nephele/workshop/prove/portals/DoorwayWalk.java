package nephele.workshop.prove.portals;

import nephele.engine.asset.LevelAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimSettings;
import nephele.host.playthrough.Playthrough;
import nephele.host.playthrough.TickInput;
import nephele.workshop.prove.portals.DoorwayRooms.Doors;
import nephele.workshop.prove.portals.FrameSteps.Step;

/** A walk through all doors of a row of rooms, drawn frame by frame. */
final class DoorwayWalk implements AutoCloseable {
    /** The view turns to 10° on either side and back, while the path remains within the doors. */
    private static final double TURN_MILLIDEGREES = 600;

    private static final double TURNS_PER_TICK = 0.06;

    /** The camera, or the carried cube. */
    enum Manner {
        EYE,
        BOOM,
        HELD_CUBE
    }

    private final Playthrough playthrough;
    private final Renderer renderer;
    private final RenderTarget picture;
    private byte[] last;
    private byte[] frame;
    private Step greatestStep = Step.NONE;

    DoorwayWalk(GlContext gl, RenderTarget picture, Doors doors, int count, Manner manner) {
        this.picture = picture;
        Vec3 cube = manner == Manner.HELD_CUBE ? DoorwayRooms.CUBE_AHEAD : DoorwayRooms.CUBE_ASIDE;
        Level level = DoorwayRooms.level(count, doors, cube);
        var settings = RenderSettings.of(
                        Output.DIRECT, Quality.HIGH.with("shadowTexels", 1024).with("viewBudget", 6))
                .with(Decoration.OFF);
        renderer =
                LevelRenderer.load(gl, level, LevelAssets.inJar(LevelAssets.JAR_LEVELS + "/doorways.json"), settings);
        playthrough = new Playthrough(
                level, new Playthrough.Beginning("doorways.json", SimSettings.DEFAULT, null), new Steps(manner));
        if (manner == Manner.BOOM) {
            playthrough.changePerson();
        }
    }

    /** Walks forward while looking from side to side. */
    private static final class Steps implements TickInput {
        private final Manner manner;
        private int tick;

        Steps(Manner manner) {
            this.manner = manner;
        }

        @Override
        public PlayerInput next() {
            int turn = (int) Math.round(TURN_MILLIDEGREES * StrictMath.cos(TURNS_PER_TICK * tick));
            tick++;
            if (tick == 1 && manner == Manner.HELD_CUBE) {
                return PlayerInput.NONE.holding(Action.CARRY);
            }
            return PlayerInput.FORWARD.turning(turn, turn / 3);
        }

        @Override
        public boolean isFinished() {
            return false;
        }
    }

    /** Simulates for so long and draws a frame. */
    byte[] frame(long nanos) {
        playthrough.advance(nanos);
        renderer.draw(playthrough.view((double) picture.width() / picture.height()), playthrough.frameState(), picture);
        last = frame;
        frame = FrameSteps.bytes(picture.readBytes());
        if (last != null) {
            greatestStep = greatestStep.or(FrameSteps.between(last, frame));
        }
        return frame;
    }

    /** Returns the greatest difference of two successive frames. */
    Step greatestStep() {
        return greatestStep;
    }

    Playthrough walk() {
        return playthrough;
    }

    @Override
    public void close() {
        renderer.close();
    }
}
