package nephele.editor.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.Optional;
import nephele.editor.action.ScriptedSession;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
final class GuideTest {
    private final ScriptedSession trial = ScriptedSession.empty();
    private final Guide guide = new Guide(trial.session());

    @BeforeEach
    void followTheLevel() {
        trial.session().listen(change -> guide.follow());
    }

    private void assertStep(GuideStep expected) {
        assertEquals(Optional.of(expected), guide.step());
    }

    @Test
    void eachStepGivesWayToTheNextWhenTheLevelHasWhatItAsksFor(@TempDir Path folder) {
        guide.start();
        assertStep(GuideStep.ROOM);
        assertEquals("brush", trial.session().toolEntry().id());
        trial.run("brush shape=room min=-5,-0.5,-5 max=5,4.5,5 wall=0.5");
        assertStep(GuideStep.LAMP);
        assertEquals("place", trial.session().toolEntry().id());
        trial.run("add kind=lights.point at=0,3.5,0");
        assertStep(GuideStep.START);
        trial.run("add kind=player at=0,0,3");
        assertStep(GuideStep.START);
        trial.run("add kind=exits at=0,0,-4");
        assertStep(GuideStep.THINGS);
        trial.run("add kind=bodies.box at=1,0.5,0", "add kind=environment.clouds at=0,9,0");
        assertStep(GuideStep.PORTALS);
        trial.run("add kind=portals at=0,1,-4.5 id=a");
        assertStep(GuideStep.PORTALS);
        trial.run("add kind=portals at=0,1,4.5 id=b", "set value=linkedTo to=a");
        assertStep(GuideStep.PLAY);
        trial.run("save file=" + folder.resolve("first.json"));
        assertTrue(guide.isRunning());
        assertEquals(Optional.empty(), guide.step());
    }

    @Test
    void itBeginsWhereTheLevelIs() {
        trial.run("brush shape=room min=-5,-0.5,-5 max=5,4.5,5 wall=0.5", "add kind=lights.point at=0,3.5,0");
        guide.start();
        assertStep(GuideStep.START);
        guide.back();
        assertStep(GuideStep.LAMP);
        guide.next();
        assertStep(GuideStep.START);
        guide.leave();
        assertFalse(guide.isRunning());
    }

    @Test
    void theCameraStandsInsideTheRoom() {
        trial.run("brush shape=room min=-5,-0.5,-5 max=5,4.5,5 wall=0.5");
        guide.start();
        var eye = trial.session().panes().activeView().perspective().eye();
        assertTrue(Math.abs(eye.x()) < 4.5 && Math.abs(eye.z()) < 4.5 && eye.y() > 0 && eye.y() < 4, eye.toString());
    }
}
