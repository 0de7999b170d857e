package nephele.engine.sim.carry;

import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.PathTrace;
import nephele.engine.portal.PathTrace.End;
import nephele.engine.portal.Portals;
import nephele.engine.sim.player.PlayerEye;
import nephele.engine.sim.state.PlayerState;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A line of sight: from a player's centre to the eye, which may be beyond a portal, and from there straight on through
 * portals up to an obstacle. One object for one set of portals, reused; the accessors refer to the last line.
 */
final class LineOfSight {
    private final Portals portals;
    private final PathTrace body;
    private final PathTrace view;
    private final Vector3d centre = new Vector3d();
    private final Vector3d way = new Vector3d();
    private double metres;

    LineOfSight(Portals portals, Obstacles obstacles) {
        this.portals = portals;
        body = new PathTrace(portals, Obstacles.NONE);
        view = new PathTrace(portals, obstacles);
    }

    /**
     * Traces a line.
     *
     * @param towards the end of the line, in the space of the player's centre, as if there were no portals in between
     */
    End look(PlayerState player, Vector3dc towards) {
        PlayerEye.centre(player, centre);
        PlayerEye.eye(player, way);
        Vector3d line = new Vector3d(towards).sub(way);
        body.trace(centre, way.sub(centre));
        metres = line.length();
        return view.trace(body.place(), body.carryDirection(line));
    }

    /** Returns the free length of the line from the eye. */
    double freeMetres() {
        return metres * view.freeFraction();
    }

    /** Returns the crossing word from the player's centre to the line's end. */
    CrossingWord word() {
        CrossingWord word = body.word();
        for (int i = 0; i < view.crossings(); i++) {
            word = word.then(view.entered(i), portals);
        }
        return word;
    }
}
