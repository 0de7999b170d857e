/** Draws the billboards of a level: those with edges among the surfaces, blended ones from the farthest to the nearest. */
package nephele.engine.render.pass.billboard;
