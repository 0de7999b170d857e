/** How the shapes of a placed level lie to each other: solids by place, parts of faces, and the leak of a closed level. */
package nephele.engine.level.layout;
