/** Does rendering work on this machine? */
package sunbeam.app.commands.doctor;
