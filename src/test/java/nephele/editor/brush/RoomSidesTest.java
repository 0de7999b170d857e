package nephele.editor.brush;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import nephele.editor.action.ScriptedSession;
import nephele.editor.document.EntityBounds;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The slabs of a drawn room are called by their sides. */
@Execution(ExecutionMode.CONCURRENT)
class RoomSidesTest {
    private static final String ROOM = "brush shape=room min=2,0,-9 max=12,4,1 wall=0.5";

    private static Map<String, Aabb> places(Level level) {
        return level.solids().stream().collect(Collectors.toMap(Solid::id, solid -> EntityBounds.of((Record) solid)));
    }

    @Test
    void eachSlabSaysWhereItIs() {
        Map<String, Aabb> places = places(ScriptedSession.empty().run(ROOM).level());
        assertEquals(
                Set.of("room-floor", "room-ceiling", "room-north", "room-south", "room-east", "room-west"),
                places.keySet());
        assertEquals(0.5, places.get("room-floor").maxY());
        assertEquals(3.5, places.get("room-ceiling").minY());
        assertEquals(-8.5, places.get("room-north").maxZ());
        assertEquals(0.5, places.get("room-south").minZ());
        assertEquals(11.5, places.get("room-east").minX());
        assertEquals(2.5, places.get("room-west").maxX());
    }

    @Test
    void aSecondRoomHasItsOwn() {
        Level level = ScriptedSession.empty()
                .run(ROOM, "brush shape=room min=20,0,0 max=30,4,9 wall=0.5", ROOM + " id=hall")
                .level();
        assertEquals(18, places(level).size());
        assertTrue(places(level).keySet().containsAll(Set.of("room-floor-2", "room-west-2", "hall-ceiling")));
    }
}
